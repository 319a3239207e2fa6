"""How the runs of an axis are driven: what a recording and a model tell of it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from ...controllers.replayed_reference import ReplayedReference
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..recordings.recording import Recording
from .halts import sticks_and_slips
from .rig import AxisRig, follower, pulling
from .signals import AxisSignals

#: The limit of a servo that has none [V].
UNLIMITED = 1e300


class Driven(NamedTuple):
    """How an axis is driven.

    Parameters
    ----------
    sensed : bool
        Whether the recorded drive is what a sensor saw (a force, a current).
    alone : bool
        Whether nothing drives it.
    servo : bool
        Whether it follows set points of its servo, or the moved end of a spring.
    pulled : bool
        Whether it is the spring of these two.
    """

    sensed: bool
    alone: bool
    servo: bool
    pulled: bool

    @property
    def told(self) -> bool:
        """Whether the recorded drive is what a driver was told to do."""
        return not (self.sensed or self.alone or self.servo)

    def rig(self, searched: Recording, signals: AxisSignals) -> AxisRig:
        """The rig that is driven so."""
        nothing = self.alone and signals.press not in searched.channels
        played = usual_row_step(searched) if nothing or self.pulled else 0.0
        return AxisRig(sensed=self.sensed, alone=self.alone, servo=self.servo, played=played)


def how_driven(
    searched: Recording, declared: Scenario, signals: AxisSignals
) -> tuple[Driven, AxisSignals]:
    """How the runs that may be searched are driven, and their signals.

    The signals say (`anew`) whether runs behind a servo or a spring are set anew from the record in
    windows: those that a prediction of the whole run could not follow.
    """
    alone = not searched.map.driven
    servo = not alone and not set(signals.drive) & searched.channels.keys()
    pulled = servo and bool(pulling(declared))
    slipping = searched, signals.position, signals.reference
    anew = pulled or (servo and forgets(declared) and sticks_and_slips(*slipping))
    sensed = bool(signals.sensed & searched.channels.keys())
    return Driven(sensed, alone, servo, pulled), replace(signals, anew=anew)


def most_told(declared: Scenario, replays: Sequence[Replay], servo: bool) -> float:
    """The largest that a driver was told, or may be by its servo [V]; 0 if nobody knows."""
    if not servo:
        return max(float(np.abs(r.inputs["drive"]).max()) for r in replays)
    limit = getattr(follower(declared), "limit", UNLIMITED)
    return limit if limit < UNLIMITED else 0.0


def forgets(declared: Scenario) -> bool:
    """Whether the servo has no memory (no integral term, no differenced speed)."""
    loop = follower(declared)
    return isinstance(loop, ReplayedReference) and not (loop.integral_gain or loop.differenced)


def usual_row_step(recording: Recording) -> float:
    """The usual time between rows [s]."""
    return float(np.median(np.concatenate([np.diff(run.time) for run in recording.runs])))
