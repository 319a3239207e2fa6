"""Runs under the Python that has Siconos: a job in JSON on standard input, an NPZ file out.

Moreau-Jean time stepping; the set-valued friction of a clutch is a relay whose impulse lies within
the torque times the step.  The default solver of relays (Lemke) fails on redundantly stuck
clutches; projected Gauss-Seidel does not.  The linkage's functions are compiled from C.
"""

import json
import os
import subprocess
import sys
import time

import numpy as np

SOURCE = """
#include <math.h>
extern "C" void mass(unsigned n, const double *q, double *M, unsigned nz, double *z) {{
  M[0] = 2 * {alpha!r}; M[3] = 2 * {beta!r}; M[1] = M[2] = -({gamma!r}) * sin(q[0] - q[1]); }}
extern "C" void gyr(unsigned n, const double *q, const double *v, double *f, unsigned nz,
                    double *z) {{
  double s = {gamma!r} * cos(q[0] - q[1]);
  f[0] = s * v[1] * v[1]; f[1] = -s * v[0] * v[0]; }}
extern "C" void load(double t, unsigned n, double *f, unsigned nz, double *z) {{
  f[0] = {first!r}; f[1] = {second!r};
{lines}}}
"""
#: Of the relay solver.
ITERATIONS, TOLERANCE = 100_000, 1e-13


def plugin(job, folder):
    """Compile the linkage's functions."""
    lines = "".join(
        f"  f[{int(j)}] += {size!r} * sin({rate!r} * t + {phase!r});\n"
        for j, size, rate, phase in job["lines"]
    )
    numbers = {name: job[name] for name in ("alpha", "beta", "gamma", "first", "second")}
    source = os.path.join(folder, "LinkagePlugin.cpp")
    with open(source, "w", encoding="utf-8") as file:
        file.write(SOURCE.format(lines=lines, **numbers))
    library = os.path.join(folder, "LinkagePlugin.so")
    subprocess.run(["g++", "-O2", "-shared", "-fPIC", source, "-o", library], check=True)


def simulation(job):
    """Time stepping, its body, and what has to be kept alive."""
    import siconos.kernel as sk
    import siconos.numerics as sn

    body = sk.LagrangianDS(job["q"], job["qd"])
    body.setComputeMassFunction("LinkagePlugin", "mass")
    body.setComputeFGyrFunction("LinkagePlugin", "gyr")
    body.setComputeFExtFunction("LinkagePlugin", "load")
    model = sk.NonSmoothDynamicalSystem(0.0, job["t_end"])
    model.insertDynamicalSystem(body)
    kept = [model]
    for row, torque in zip(job["rows"], job["torques"], strict=True):
        impulse = torque * job["step"]
        law = sk.RelayNSL(1, -impulse, impulse)
        # Far from contact by -1e9, a relay is active always.
        relation = sk.LagrangianLinearTIR([row], [-1e9])
        joint = sk.Interaction(law, relation)
        model.link(joint, body)
        kept += [law, relation, joint]
    stepping = sk.TimeStepping(model, sk.TimeDiscretisation(0.0, job["step"]))
    stepping.insertIntegrator(sk.MoreauJeanOSI(job["theta"]))
    relays = sk.Relay(sn.SICONOS_RELAY_PGS)
    options = relays.numericsSolverOptions()
    options.iparam[sn.SICONOS_IPARAM_MAX_ITER] = ITERATIONS
    options.dparam[sn.SICONOS_DPARAM_TOL] = TOLERANCE
    stepping.insertNonSmoothProblem(relays)
    stepping.setNewtonTolerance(1e-12)
    stepping.setNewtonMaxIteration(30)
    return stepping, body, [*kept, relays]


def main():
    job = json.load(sys.stdin)
    os.chdir(job["folder"])
    plugin(job, job["folder"])
    stepping, body, _kept = simulation(job)
    speed = np.zeros((round(job["t_end"] / job["step"]), 2))
    start = time.process_time()
    for k in range(len(speed)):
        stepping.computeOneStep()
        speed[k] = body.velocity()
        stepping.nextStep()
    cpu = time.process_time() - start
    np.savez(job["out"], speed=speed, q=body.q(), cpu=cpu)


main()
