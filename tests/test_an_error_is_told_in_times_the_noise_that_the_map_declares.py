"""What the map says of noise is no estimate, and a verdict does not call it one."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.held_out_sentences import floor_known_by
from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE_AXIS


def known_by(speed, drive=None, sensed=False, limits=SINGLE_AXIS):
    noises = {"speed": (speed, "measured"), "drive": (drive, "input"), "angle": (None, "measured")}
    channels = {n: SimpleNamespace(noise=x, role=role) for n, (x, role) in noises.items()}
    split = SimpleNamespace(report=[SimpleNamespace(observed={"speed": None})])
    limits = limits._replace(drive=sensed)
    recording = SimpleNamespace(channels=channels)
    return floor_known_by(SimpleNamespace(limits=limits, recording=recording, split=split))


@pytest.mark.parametrize(("drive", "sensed"), [(None, False), (0.1, True)])
def test_noise_of_all_that_is_in_the_floor_is_declared(drive, sensed):
    assert known_by(0.08, drive, sensed) == "noise declared in the map"


@pytest.mark.parametrize(("speed", "sensed"), [(None, False), (0.08, True)])
def test_else_some_of_it_is_estimated(speed, sensed):
    assert known_by(speed, None, sensed) == "noise estimated from single runs"


def test_repeated_runs_show_the_floor_whatever_is_declared():
    assert known_by(0.08, limits=REPEATED) == REPEATED.known_by
