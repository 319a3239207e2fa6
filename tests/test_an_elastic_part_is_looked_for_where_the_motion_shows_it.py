"""Where fits of an elastic part begin: the recorded motion tells all but the last per cents."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.flexible import flexible_candidates, shown_by_motion
from simpter_hybrid.identification.fitting.replay import Replay

STEP, HIGHEST, MASS = 0.002, 125.0, 2.0
TIME = np.arange(0.0, 8.0, STEP)


def recorded(part: float, frequency: float, damping: float, friction: float = 3.0, noise=0.0):
    """A run of an own simulation by small steps: two masses, one of them rubs."""
    fine, random = 20, np.random.default_rng(3)
    force = sum(4.0 * np.sin(2 * np.pi * f * TIME + f) for f in (0.4, 0.9, 1.7, 2.9))
    h, rate = STEP / fine, 2 * np.pi * frequency
    own, hung = MASS * (1.0 - part), MASS * part
    x = v = r = u = 0.0
    rows = np.empty((TIME.size, 2))
    for k, push in enumerate(force.tolist()):
        rows[k] = x, v
        for _ in range(fine):
            drawn = rate * (rate * r + 2 * damping * (u - v))
            ahead = v + h * (push + hung * drawn) / own
            slowed = h * friction / own
            v = 0.0 if abs(ahead) <= slowed else ahead - np.sign(ahead) * slowed
            u -= h * drawn
            x, r = x + h * v, r + h * (u - v)
    speed = rows[:, 1] + noise * random.standard_normal(TIME.size)
    notes = {"position": rows[:, 0], "speed": speed}
    return Replay("run", "run", TIME, {"drive": force}, {}, notes=notes)


@pytest.mark.parametrize(("frequency", "damping"), [(7.0, 0.02), (12.0, 0.1)])
def test_its_frequency_and_size_are_told_by_the_motion(frequency, damping):
    found = shown_by_motion([recorded(0.25, frequency, damping)], HIGHEST)
    # Tried are frequencies 10 % apart; speeds are smoothed over hundredths of a second.
    assert found.frequency == pytest.approx(frequency, rel=0.1)
    assert 0.05 < found.part < 0.35


def test_of_a_rigid_mass_nothing_or_next_to_nothing_is_told():
    found = shown_by_motion([recorded(0.0, 5.0, 0.02, noise=1e-3)], HIGHEST)
    assert found is None or found.part < 0.05


def test_rows_too_far_apart_to_show_a_swing_have_no_such_candidate():
    run = recorded(0.25, 7.0, 0.02)
    every = 300
    slow = {name: values[::every] for name, values in run.notes.items()}
    drive = {"drive": run.inputs["drive"][::every]}
    thin = Replay("run", "run", TIME[::every], drive, {}, notes=slow)
    assert flexible_candidates([thin], MASS, False) == ()
    (found,) = flexible_candidates([run], MASS, False)
    assert found.name == "flexible-mode"
    assert "clutch" not in found.experiment
