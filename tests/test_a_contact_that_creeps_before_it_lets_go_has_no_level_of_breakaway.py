"""Small slips under a push that holds more later are no breakaways."""

import numpy as np
import pytest

from simpter_hybrid.identification.rotor.conditioning import conditions, creeping

STEP, NOISE = 0.002, 0.01
COMMAND = np.full(1500, 5.0)


def _ramp(creeps: bool):
    """A ramp of 100/s from 0 s, gross slip from 1.0 to 2.0 s; with three small slips before."""
    time = np.arange(1500) * STEP
    speed = np.where((time >= 1.0) & (time < 2.0), 3.0, 0.0)
    if creeps:
        for begin in (0.3, 0.5, 0.7):
            speed += np.where((time >= begin) & (time < begin + 0.06), 0.2, 0.0)
    held = np.where(time < 1.0, 100.0 * time, 90.0)
    position = np.cumsum(speed) * STEP
    noisy = speed + NOISE * np.random.default_rng(1).standard_normal(time.size)
    return time, position, noisy, np.where(time < 2.0, held, 0.0)


@pytest.mark.parametrize("creeps", [False, True])
def test_only_a_gross_slip_is_left_out_and_levelled_and_every_slip_is_restarted(creeps):
    found = conditions(*_ramp(creeps), NOISE, 0.5, 0.01, COMMAND, 1e-4)
    assert len(found.breakaways) == (0 if creeps else 1)
    first = 0.3 if creeps else 1.0
    assert first <= min(r.index for r in found.restarts) * STEP <= first + 0.03
    assert found.keep[: int(0.95 / STEP)].all()


def test_a_slip_at_a_lower_command_is_a_breakaway_though_more_is_held_later():
    position = np.where(np.arange(100) < 12, 0.0, 0.1) + 0.2 * np.maximum(np.arange(100) - 50, 0)
    held, command = np.full(100, 1.0), np.full(100, 3.0)
    asked = ([10, 50], [12, 60], [1.0, 2.0], position, held)
    assert creeping(*asked, command) == [True, False]
    command[40:] = 5.0
    assert creeping(*asked, command) == [False, False]


@pytest.mark.parametrize("gives", [0.0, 2e-3])
def test_a_contact_that_gives_while_its_torque_rises_has_no_level(gives):
    time, position, speed, held = _ramp(creeps=False)
    yields = gives * np.clip(time / 1.0, 0.0, 1.0)  # 2 mrad/s: far below what a speed sensor shows
    found = conditions(time, position + yields, speed, held, NOISE, 0.5, 0.01, COMMAND, 1e-4)
    assert len(found.breakaways) == (0 if gives else 1)


@pytest.mark.parametrize("later", [95.0, 140.0])
def test_what_transmits_more_as_it_slips_on_did_not_break_away(later):
    time, position, speed, held = _ramp(creeps=False)
    held = np.where((time > 1.3) & (time < 1.9), later, held)
    found = conditions(time, position, speed, held, NOISE, 0.5, 0.01, COMMAND, 1e-4)
    assert len(found.breakaways) == (0 if later > 125.0 else 1)
