"""On what a residual depends, in words."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..tracing.limits import IMPERFECT, SINGLE_AXIS
from ..tracing.locating import located
from ..tracing.named import OF_BOTH, REVERSAL, balance_of, coordinate_of
from ..tracing.signature import Dependence
from ..tracing.slow_state import RUN

#: Coordinates that a sentence mentions.
MENTIONED = 4
#: A coordinate that takes this part of the square of what is left away tells most of it.
MOST = 0.5
#: More of a mean square than this is not called a little beside noise: noise of a drive that is not
#: white does not put so much into nulls, and where no effect helps it tells of a lack by itself.
LITTLE = SINGLE_AXIS.dependence
#: Where a lack sits, by the balance in which it shows.
PLACES = {
    "friction": "friction, actuator or torque sensor",
    "load": "load, inertia or torque sensor, not friction",
    "breakaway": "the level of breakaway",
    "vibration": "a vibration: how much the torque spreads from sample to sample",
    "ringing": "the torque rings after each",
}
#: On what such an error depends: itself, or what grows with its drift.
OF_A_SENSOR = ("torque", "time", "heat", "distance")
#: With one friction on one axis its slip velocity is the speed, with a sign: one of them is told.
SAME = ("force:speed", "force:slip_velocity")
#: What a coordinate is called, where its name does not say it.
CALLED = {
    RUN: "a slow state that was not recorded (another in each run)",
    "same_way": "whether it slipped the same way before",
    "slips_before": "how often it has slipped before in a run",
    "load_rate": "how fast the torque rises before it",
}


def is_straight(found: Any) -> bool:
    """Whether all coordinates of a diagnosed rig are lengths: what acts on it are forces."""
    try:
        kinds = found.search.corrected.predictor.declared.device.coordinate_dimensions
    except AttributeError:  # not every predictor has a scenario
        return False
    return bool(kinds) and {*kinds} == {"length"}


def depends_on(coordinates: Sequence[str], straight: bool = False) -> str:
    """``speed (friction, actuator or torque sensor)``; of a `straight` axis torques are forces."""
    force = "force" if straight else "torque"
    places: dict[str, list[str]] = {}
    twice = [c for c in coordinates if c in SAME][1:]
    for coordinate in (c for c in coordinates if c not in twice):
        name = coordinate_of(coordinate)
        called = force if name == "torque" else CALLED.get(name, name.replace("_", " "))
        places.setdefault(balance_of(coordinate), []).append(called)
    said = {
        b: f"{_first(names)}{_where(b).replace('torque', force)}" for b, names in places.items()
    }
    one, other = (places.get(balance, []) for balance in OF_BOTH)
    both = [name for name in one if name in other and name in OF_A_SENSOR]
    if both:
        text = " (both have the torque sensor in common, and " + " and ".join(both[:MENTIONED])
        said[[b for b in places if b in OF_BOTH][-1]] += f"{text})"
    return "; ".join(said.values()) or "nothing that was looked at"


def among_others(
    where: Sequence[str], dependences: Sequence[Dependence], straight: bool = False
) -> str:
    """Words on coordinates that surely tell less than those of `where`; "" if these tell most.

    Where none takes `MOST` of the square away they may all go along with what nobody looked at:
    friction that rises with acceleration was one of displacement since reversal, with 0.29 of the
    square, and acceleration, with 0.14, was not told.
    """
    gains = {d.coordinate: d.gain for d in dependences}
    told = [gains.get(c, MOST) for c in where]
    gone = {*where, *(SAME if {*SAME} & {*where} else ())}
    others = [c for c in located(dependences, alike=0.0) if c not in gone]
    if not told or not others or max(told) >= MOST:
        return ""
    return f", among others (less on {depends_on(others, straight)})"


def _where(balance: str) -> str:
    """Words on the place of a lack; none for the one balance of an axis, which tells no place."""
    return "" if balance == "force" else f" ({PLACES.get(balance, balance)})"


def _first(names: Sequence[str]) -> str:
    """The first few coordinates in words, and the number of those that go with them."""
    more = len(names) - MENTIONED
    return " and ".join(names[:MENTIONED]) + (f" (and {more} that go with it)" if more > 0 else "")


def as_well(coordinates: Sequence[str], straight: bool = False) -> str:
    """Words on what would do as well: other coordinates, or what differs between runs."""
    others = [c for c in coordinates if coordinate_of(c) != RUN]
    # This is asked only of what goes one way: there both are one.
    ways = [c for c in others if coordinate_of(c) == "distance"]
    twice = {f"{balance_of(c)}:{REVERSAL}" for c in ways}
    others = [c for c in others if c not in twice]
    said = [f"any dependence on {depends_on(others, straight)}"] if others else []
    if len(others) < len(coordinates):
        said.append("whatever differs from run to run")
    return " or ".join(said)


def hardly_left_text(found: Any, on: str, held: float) -> str:
    """Words on what goes along with coordinates where an effect leaves no more than its limit.

    It is called noise only where the runs held out show no more either (nor more than forms of
    right effects leave: a limit may allow for a floor that few runs tell), and where so little
    goes along that it tells of no lack by itself.

    Parameters
    ----------
    found : Diagnosis
    on : str
        The coordinates, in words.
    held : float
        Error on the runs held out, over the floor.
    """
    last = found.search.rounds[-1]
    left = last.after if last.verdict.accepted is not None else last.before
    parts = [
        d.gain
        for balance, dependences in left.items()
        for d in dependences
        if f"{balance}:{d.coordinate}" in found.search.verdict.coordinates
    ]
    much = f" ({100 * max(parts):.1f} % of its mean square)" if parts else ""
    if held > min(found.limits.form, IMPERFECT):
        return f" What is left depends on {on}{much}."
    if max(parts, default=0.0) > LITTLE:
        return f" What is left is as large as noise, but goes along with {on}{much}."
    return f" What is left is noise but for a little{much} that goes along with {on}."
