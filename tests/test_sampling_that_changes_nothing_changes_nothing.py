"""Extra sample instants end segments, but a run is the same to rounding."""

import numpy as np
import pytest
from random_runs import RecordedCommands, random_run

from simpter_hybrid.engine import simulate


def same_end(first, second):
    """Final states agree to 1e-9 of their size."""
    size = np.abs(first.end).max()
    assert first.end == pytest.approx(second.end, abs=1e-9 * size)
    assert [e.after for e in first.events] == [e.after for e in second.events]


@pytest.mark.parametrize("seed", [1, 2, 4])
@pytest.mark.parametrize("rate", [30.0, 211.0])
def test_commands_written_again(seed, rate):
    plain = random_run("constant", seed, 2.0)
    rows = plain.command * (int(2.0 * rate) + 2)
    again = plain.replace(controllers=((RecordedCommands(), 1),), period=1.0 / rate, rec=rows)
    same_end(simulate(plain), simulate(again))


@pytest.mark.parametrize("seed", [0, 2])
def test_a_shorter_base_period_with_the_same_samples(seed):
    plain = random_run("30 Hz", seed, 1.5)
    often = plain.replace(controllers=((RecordedCommands(), 5),), period=plain.period / 5.0)
    same_end(simulate(plain), simulate(often))
