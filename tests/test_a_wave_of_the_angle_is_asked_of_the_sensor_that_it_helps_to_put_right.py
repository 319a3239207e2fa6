"""An encoder off its axis and a tachometer that ripples make one wave: a refit may tell which."""

import numpy as np
import pytest

from simpter_hybrid.identification.doubted_channels import Doubt
from simpter_hybrid.identification.doubted_readings import waves_asked
from simpter_hybrid.identification.map_changes import EvenSpeed, OnAxis
from simpter_hybrid.identification.recordings.off_axis import OffAxis, put_even
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence

OFF = OffAxis("position", "speed", 0.0, -0.03)
ENCODER, TACHOMETER = OnAxis(("position",), OFF), EvenSpeed(("speed",), OFF)


@pytest.mark.parametrize(
    ("encoder", "tachometer", "compared", "kept"),
    [
        (0.04, 1.2, True, [ENCODER]),
        (1.0, 0.3, True, [TACHOMETER]),
        (0.95, 0.94, True, [TACHOMETER, ENCODER]),
        (1.0, 1.1, True, [ENCODER]),  # the record shows it all the same
        (1.0, 1.1, False, []),
        (1.0, 0.94, False, [TACHOMETER]),
    ],
)
def test_that_is_kept_which_helps(encoder, tachometer, compared, kept):
    left = [Doubt(ENCODER, encoder), Doubt(TACHOMETER, tachometer)]
    assert [d.change for d in waves_asked(left, compared)] == kept


def test_a_speed_with_the_ripple_is_put_right_by_it():
    time = np.linspace(0.0, 10.0, 2001)
    angle, speed = 2.0 * time + np.sin(time), 2.0 + np.cos(time)
    shown = speed * (1.0 + 0.03 * np.cos(angle))  # summed up it has 0.03 sin(q) too much
    both = {"position": angle, "speed": shown}
    (run,) = put_even([RecordedRun("a", "", "", (0, time.size), time, both)], OFF)
    assert run.channels["speed"] == pytest.approx(speed)


def test_what_leaves_nearly_all_is_not_said_to_leave_only_that():
    said = doubted_sentence([Doubt(TACHOMETER, 0.94)])
    assert said.startswith("Does a tachometer ripple? With speed less a ripple of 3 % once a turn")
    assert " 94 %" in said
    assert "only" not in said
    assert said.endswith("An encoder off its axis would show the same wave.")


def test_the_tachometer_is_asked_as_well_where_the_encoder_does_not_help():
    said = doubted_sentence([Doubt(ENCODER, 1.0)])
    assert said.startswith("Is an encoder off its axis, or does a tachometer ripple?")
    assert "only" not in said


@pytest.mark.parametrize(("noise", "all_of_it"), [(0.94, True), (0.9, False)])
def test_it_is_said_where_what_is_left_is_noise(noise, all_of_it):
    said = doubted_sentence([Doubt(TACHOMETER, 0.94)], noise)
    assert ("error is left, no more than noise leaves." in said) is all_of_it
