"""Effects of a logged temperature, on every rig whose recording has one that varies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...effects.by_temperature import DragByTemperature, FrictionByTemperature
from ...scenario import Scenario
from ..fitting.replay import Replay
from .candidate import candidate
from .effect_candidate import EffectCandidate
from .following import known_levels

#: Most by which friction may change over the span of the record, and a typical change.
MOST, TYPICAL = 0.9, 0.03
#: Where the lack of one shows: along the channel, and as what warms up by itself does.
ALONG = ("temperature", "time", "distance", "heat")


def temperature_candidates(
    declared: Scenario, replays: Sequence[Replay], force: float, speed: float
) -> tuple[EffectCandidate, ...]:
    """Friction and drag by the logged temperature; none where it was not logged or never varies.

    Parameters
    ----------
    declared : Scenario
        Friction is changed on all its clutches, drag on all its coordinates.
    replays : sequence of Replay
        The fitted runs: the reference is their mean temperature.
    force, speed : float
        Largest in the record [N or N m, m/s or rad/s].
    """
    every = known_levels(replays, FrictionByTemperature().follows())
    if not every.size or np.ptp(every) <= 0.0:
        return ()
    span = float(np.ptp(every))
    n, m = declared.device.n, declared.device.m
    return temperature_library(n, m, round(float(np.mean(every)), 1), span, force / speed / span)


def temperature_library(
    n: int, m: int, reference: float, span: float, drag: float
) -> tuple[EffectCandidate, ...]:
    """Candidates by temperature for a device, given the numbers of a record.

    Parameters
    ----------
    n, m : int
        Number of coordinates and of clutches of the device.
    reference, span : float
        Mean of the logged temperature and its range [K].
    drag : float
        A large change of viscous drag for each kelvin [N m s/(rad K) or N s/(m K)].
    """
    course = ((0.0, reference),)
    rubs = [FrictionByTemperature(clutch=i, reference=reference, points=course) for i in range(m)]
    drags = [DragByTemperature(coordinate=j, reference=reference, points=course) for j in range(n)]
    most, typical = MOST / span, TYPICAL / span
    found: tuple[EffectCandidate, ...] = (
        candidate(
            "friction-by-temperature", rubs[0], (("change", -most, most, typical),), ((0.0,),),
            ALONG, more=tuple(rubs[1:]),
        ),
        candidate(
            "drag-by-temperature", drags[0], (("change", -20.0 * drag, 20.0 * drag, 0.02 * drag),),
            ((0.0,),), ALONG, more=tuple(drags[1:]),
        ),
    )  # fmt: skip
    if n == m == 1:  # what is dry and what is viscous, each by its own
        both = "friction-by-temperature-2"
        fields = ("1.change", -most, most, typical), ("2.change", -20 * drag, 20 * drag, drag / 50)
        made = candidate(
            both, rubs[0], fields, ((0.0, 0.0),), ALONG, more=tuple(drags),
            simpler=found[0].name, contains=(found[1].name,),
        )  # fmt: skip
        found += (replace(made, sizes=tuple(p.name for p in made.parameters)),)
    balances = ("friction", "force", "load", *(f"joint_{j + 1}" for j in range(n)))
    where = tuple(f"{balance}:{c}" for balance in balances for c in ALONG)
    return tuple(replace(c, coordinates=where) for c in found)
