"""Runs that begin in motion and never go back do not ask for a bristle; others do."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.sizes import sizes_of
from simpter_hybrid.identification.fitting.replay import Replay

TIME = np.linspace(0.0, 2.0, 401)
COASTS = 20.0 * np.exp(-TIME)
SWINGS = 3.0 * np.cos(5.0 * TIME) * np.exp(-TIME)
STARTS = 20.0 * (1.0 - np.exp(-TIME))


def tried(*speeds):
    """Families that are tried on runs with these speeds."""
    runs = [
        Replay("run", "run", TIME, {}, {}, notes={"speed": v, "position": np.cumsum(v) * 5e-3})
        for v in speeds
    ]
    return {c.family for c in axis_candidates(sizes_of(runs, 1.0, 0.1, turning=True))}


@pytest.mark.parametrize("runs", [(COASTS,), (COASTS, -COASTS)])
def test_what_only_coasts_is_asked_for_none(runs):
    assert "presliding" not in tried(*runs)


#: Coasts down to rest, and is pushed on.
AGAIN = np.where(TIME < 1.0, 20.0 * (1.0 - TIME), np.where(TIME < 1.2, 0.0, 15.0))
RESTS = np.maximum(0.0, 20.0 * (1.0 - TIME))


def test_what_coasts_to_rest_is_asked_for_none_either():
    assert "presliding" not in tried(RESTS)


@pytest.mark.parametrize("runs", [(SWINGS,), (STARTS,), (COASTS, SWINGS), (AGAIN,)])
def test_what_turns_round_or_starts_from_rest_is(runs):
    assert "presliding" in tried(*runs)
