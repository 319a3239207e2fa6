"""A slide that sticks and slips halts where its set points go on; turns and stairs are no halts."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.halts import halts

STEP = 2e-3
TIME = np.arange(0.0, 4.0, STEP)


def stairs(number: int) -> np.ndarray:
    """Each a rest of half its time and a smooth way on of 1 mm."""
    turn = TIME / TIME[-1] * number
    rise = np.clip(2.0 * (turn % 1.0) - 1.0, 0.0, 1.0)
    return 1e-3 * (np.floor(turn) + rise**2 * (3.0 - 2.0 * rise))


@pytest.mark.parametrize("number", [4, 10])
def test_every_halt_between_two_stretches_the_same_way_counts(number):
    # At either end a rest has nothing before it or after it.
    assert halts(stairs(number), STEP, 1e-5) == number - 1


@pytest.mark.parametrize(
    "course", [5e-3 * TIME, 5e-3 * np.sin(12.0 * TIME), np.zeros(TIME.size)]
)  # fmt: skip
def test_a_steady_way_and_turns_are_none(course):
    assert halts(course, STEP, 1e-5) == 0


def test_steps_of_a_coarse_encoder_are_none():
    read = np.round(5e-4 * TIME / 1e-4) * 1e-4  # a count every 0.2 s
    assert halts(read, STEP, 10.0 * 1e-4) <= 1
