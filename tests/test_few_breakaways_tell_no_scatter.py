"""Seven breakaways tell their scatter to a quarter at best: it is then taken as declared."""

from dataclasses import replace

import numpy as np
import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.floor import noise_factors
from simpter_hybrid.identification.fitting.replay import Breakaway


def _breaks(seed, count):
    """A run whose breakaways scatter by twice what they are said to."""
    draw = np.random.default_rng(seed)
    levels = 5.0 + 0.2 * draw.standard_normal(count)
    events = tuple(Breakaway(200 * k, level, 0.1) for k, level in enumerate(levels, 1))
    return replace(toy_replay("run", seed), breakaways=events)


@pytest.mark.parametrize(("count", "factor"), [(7, 1.0), (40, 2.0)])
def test_what_repeated_runs_break_away_at(count, factor):
    told = noise_factors([_breaks(1, count), _breaks(2, count)]).get("breakaway", 1.0)
    # 40 tell it to 1 / sqrt(80); three of them.
    assert told == pytest.approx(factor, rel=0.34)
