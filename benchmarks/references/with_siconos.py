"""The linkage in Siconos, whose Debian package lives with the system's own Python."""

from __future__ import annotations

import json
import os
import subprocess
import tempfile
from pathlib import Path

import numpy as np
from answer import Answer, thinned
from linkage import DEVICE, LOAD, START, T_END, TORQUES

#: The Python that finds the module.
PYTHON = "/usr/bin/python3"
ROWS = [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0], [1.0, 1.0]]
#: Slip below which a clutch is taken to stick [rad/s]: the relay solver's tolerance over the step.
CREEP = 1e-7


def available() -> bool:
    """Whether that Python has Siconos."""
    if not Path(PYTHON).exists():
        return False
    said = subprocess.run([PYTHON, "-c", "import siconos.kernel"], capture_output=True)
    return said.returncode == 0


def solve(step: float, theta: float = 0.5) -> tuple[Answer, float]:
    """The run and its processor time [s]; `theta` 1 is backward Euler, 0.5 the trapezoidal rule."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "run.npz"
        job = {
            "alpha": DEVICE.alpha, "beta": DEVICE.beta, "gamma": DEVICE.gamma,
            "first": LOAD.first, "second": LOAD.second, "lines": LOAD.lines, "rows": ROWS,
            "torques": TORQUES, "q": START, "qd": (0.0, 0.0), "t_end": T_END, "step": step,
            "theta": theta, "folder": folder, "out": str(out),
        }  # fmt: skip
        subprocess.run(
            [PYTHON, str(Path(__file__).with_name("siconos_linkage.py"))],
            input=json.dumps(job), text=True, check=True, capture_output=True,
            env={**os.environ, "LD_LIBRARY_PATH": folder},
        )  # fmt: skip
        found = np.load(out)
        speed, end = found["speed"], found["q"]
        cpu = float(found["cpu"])
    slip = speed @ np.array(ROWS).T
    modes = np.where(np.abs(slip) <= CREEP, 0, np.sign(slip)).astype(int)
    return Answer(np.concatenate([end, speed[-1]]), thinned(modes, step)), cpu
