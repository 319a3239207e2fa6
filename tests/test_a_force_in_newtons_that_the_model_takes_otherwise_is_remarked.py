"""A sensed force acts as it is: another constant than one is remarked, a refitted gain is not."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.axis.recorded import scaled_force
from simpter_hybrid.loads.drive import CurrentDrive, ForceDrive


def _remarks(load, unit, name="force"):
    recording = SimpleNamespace(channels={name: SimpleNamespace(unit=unit)})
    return scaled_force(recording, SimpleNamespace(loads=(load,)))


def test_it_says_how_many_times_it_acts():
    (said,) = _remarks(ForceDrive(0.0274), "N")
    assert "takes channel force times 0.0274" in said.what


@pytest.mark.parametrize(
    ("load", "unit", "name"),
    [
        (ForceDrive(1.0), "N", "force"),
        (ForceDrive(1.03), "N*m", "torque"),  # a sensor's gain, refitted
        (ForceDrive(0.0274), "V", "drive"),  # a driver's command
        (CurrentDrive(0.0274), "A", "current"),
    ],
)
def test_else_nothing(load, unit, name):
    assert _remarks(load, unit, name) == ()
