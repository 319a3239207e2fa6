"""Speeds of a run, coordinate by coordinate, however its rig keeps them."""

from __future__ import annotations

import numpy as np

from ..fitting.replay import Replay


def recorded_speeds(replay: Replay) -> list[np.ndarray]:
    """The speed of each coordinate (samples,); none of a run without any.

    An axis and a rotor have one in their notes, two joints one by one, a tip all in one array.
    """
    notes = (v for name, v in replay.notes.items() if name.startswith("speed"))
    return [course for speed in notes for course in np.atleast_2d(speed)]
