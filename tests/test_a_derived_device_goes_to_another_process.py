"""A class that was made at run time is no module's there: its text goes with the device."""

import copy
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


def sled():
    q, w, mass = sp.symbols("x v mass")
    kinetic = mass * w**2 / 2
    return derive_device("Sled", [q], [w], kinetic, {"rail": q}, {mass: ("mass", 1.5)})


class Heavier(type(sled())):
    """A class of its own, with another mass."""

    @staticmethod
    def mass_matrix(q, p, out):
        out[0] = 2.0 * p[0]


def test_a_class_made_of_it_stays_that():
    made = Heavier(mass=3.0)
    for again in (copy.copy(made), pickle.loads(pickle.dumps(made))):
        assert type(again) is Heavier
        assert again == made


def test_with_its_numbers_and_its_equations():
    made = sled()
    done = subprocess.run(
        [sys.executable, "-c", THERE], input=pickle.dumps(made), capture_output=True, check=True
    )
    assert done.stdout.decode().split() == ["Sled", "1.5", "1.5"]
