"""A class that was made at run time is no module's there: its text goes with the device."""

import pickle
import subprocess
import sys

import sympy as sp

from simpter_hybrid.derive import derive_device

THERE = """
import pickle, sys
device = pickle.load(sys.stdin.buffer)
out = [0.0]
device.mass_matrix([0.3], list(device.parameters().values()), out)
print(type(device).__name__, device.mass, out[0])
"""


def test_with_its_numbers_and_its_equations():
    q, w, mass = sp.symbols("x v mass")
    kinetic = mass * w**2 / 2
    made = derive_device("Sled", [q], [w], kinetic, {"rail": q}, {mass: ("mass", 1.5)})
    done = subprocess.run(
        [sys.executable, "-c", THERE], input=pickle.dumps(made), capture_output=True, check=True
    )
    assert done.stdout.decode().split() == ["Sled", "1.5", "1.5"]
