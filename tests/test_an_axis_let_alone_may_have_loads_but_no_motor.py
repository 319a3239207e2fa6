"""A weight on a cord pulls an axis that is let alone: no motor is asked of its model."""

from dataclasses import replace

import numpy as np
from coasting_rotor import declared, logged

from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.loads.motor import HeldTorque
from simpter_hybrid.loads.ramp import RampOnCoordinate


def test_a_constant_pull_slows_what_runs_down(tmp_path):
    recording = as_recorded(logged(tmp_path))
    found = []
    for loads in ((), (RampOnCoordinate(base=-0.01),)):
        bench = bench_of(recording, replace(declared(), loads=loads), groups_of(recording))
        values = {p.name: p.value for p in bench.predictor.parameters}
        found.append(bench.predictor.simulated(values, bench.parts["fit"][:1])["speed"][0])
    free, pulled = found
    time = 0.01 * np.arange(free.size)
    # Of 0.02 kg m^2, less what less viscous drag gives back in 4 s.
    assert np.all(free[100:] - pulled[100:] > 0.3 * time[100:])
    assert np.all(free - pulled <= 0.5 * time + 1e-6)


def test_a_motor_that_nothing_tells_a_torque_is_off():
    model = replace(declared(), loads=(HeldTorque(), RampOnCoordinate(base=-0.01)))
    off, pull = AxisRig(alone=True).template(model).loads
    assert off == RampOnCoordinate(base=0.0, slope=0.0)
    assert pull == model.loads[1]
