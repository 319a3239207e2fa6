"""A torque sensor that shows something of a clutch that is off: no run carries a torque by that."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.rotor.beginnings import beginning_remarks
from simpter_hybrid.identification.rotor.idle_torque import idle_torque
from simpter_hybrid.identification.rotor.signals import RotorSignals

TIME, SETTLES, ZERO = 0.002 * np.arange(1, 1001), 0.1, 0.9
SD = {"clutch_torque": 0.2, "motor_torque": 0.3, "speed": 0.01, "position": 1e-4}


def run_of(command, carried=0.0, zero=ZERO):
    """A rotor at rest, whose clutch carries a torque once it is on, and from the start on."""
    nothing = np.zeros(TIME.size)
    torque = zero + np.where(command > 0.0, 7.0, 0.0)
    torque[:20] += carried - (torque[:20] - zero)
    channels = {
        "clutch_torque": torque, "motor_torque": nothing, "speed": nothing, "position": nothing,
        "command": command, "reference_torque": nothing * np.nan, "reference_speed": nothing,
    }  # fmt: skip
    return RecordedRun("run", "run", "", (0, TIME.size), TIME, channels)


LATE, AT_ONCE = np.where(TIME > 1.0, 4.0, 0.0), np.full(TIME.size, 4.0)


def remarks(*runs):
    return beginning_remarks(SimpleNamespace(runs=runs), RotorSignals(), SD, SETTLES)


@pytest.mark.parametrize("zero", [ZERO, -ZERO, 0.0])
def test_runs_from_rest_begin_at_rest_whatever_the_zero(zero):
    assert remarks(run_of(LATE, zero=zero), run_of(AT_ONCE, zero=zero)) == ()


def test_a_torque_beyond_the_zero_is_carried():
    (said,) = remarks(run_of(LATE), run_of(AT_ONCE, carried=5.0))
    assert "under way" in said.what
    assert said.value == "1 run"


def test_where_the_clutch_is_never_off_there_is_none():
    assert idle_torque([run_of(AT_ONCE)], RotorSignals(), SETTLES) == 0.0


def test_rows_shortly_behind_a_command_are_not_asked():
    early = np.where(TIME < 1.0, 4.0, 0.0)
    run = run_of(early)
    run.channels["clutch_torque"][(TIME > 1.0) & (TIME < 1.09)] += 3.0  # it dies away
    assert idle_torque([run], RotorSignals(), SETTLES) == pytest.approx(ZERO)
