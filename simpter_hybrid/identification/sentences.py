"""What a diagnosis says, in sentences."""

from __future__ import annotations

from collections.abc import Sequence

from .diagnosis import Found
from .verdict import OFF_FLOOR

#: Where a lack sits, by the balance in which it shows.
PLACES = {
    "friction": "friction, actuator or torque sensor",
    "load": "load or inertia, not friction",
    "breakaway": "the level of breakaway",
}


def verdict_sentence(found: Found) -> str:
    """The sentence a reader wants first."""
    verdict = found.diagnosis.verdict
    names = [e.name for e in found.diagnosis.corrected.effects]
    ratio = found.diagnosis.corrected.select / found.diagnosis.floor
    if verdict.kind == "nothing missing":
        if ratio <= OFF_FLOOR:
            return "Nothing is missing: what the refitted model leaves is noise."
        return (
            "Nothing that these data could show is missing: no effect helps, and what is left "
            f"depends on nothing that was looked at. It is {ratio:.2f} times the floor, more than "
            "noise alone."
        )
    if verdict.kind == "unknown":
        return (
            "Something is missing and none of the known effects explains it: "
            f"it depends on {depends_on(verdict.coordinates)}."
        )
    text = " and ".join(names) or "an effect"
    # A rival of the first round that a later round has added is no rival any more.
    others = [t.candidate.name for t in verdict.rivals if t.candidate.name not in names]
    if verdict.kind == "cannot be told apart" and others:
        also = ", ".join(others)
        return f"These data point to {text}, but do not exclude {also} in its place."
    if verdict.as_well:
        also = as_well(verdict.as_well)
        return f"These data point to {text}, but {also} would do as well."
    if verdict.kind == "form incomplete" or ratio > OFF_FLOOR:
        on = depends_on(verdict.coordinates)
        left = f"; what is left depends on {on}" if verdict.coordinates else ""
        return (
            f"The model lacks {text}; its form is incomplete (the error stays at {ratio:.2f} "
            f"times the floor){left}."
        )
    return f"The model lacks {text}; with it the error is {ratio:.3f} times the replicate floor."


def depends_on(coordinates: Sequence[str]) -> str:
    """``speed (friction, actuator or torque sensor)``."""
    places: dict[str, list[str]] = {}
    for coordinate in coordinates:
        balance, _, name = coordinate.partition(":")
        places.setdefault(balance, []).append(name.replace("_", " "))
    said = [f"{' and '.join(names)} ({PLACES.get(b, b)})" for b, names in places.items()]
    return "; ".join(said) or "nothing that was looked at"


def as_well(coordinates: Sequence[str]) -> str:
    """What would do as well: a dependence on other coordinates, or what differs between runs."""
    others = [c for c in coordinates if not c.endswith(":run")]
    said = [f"any dependence on {depends_on(others)}"] if others else []
    if len(others) < len(coordinates):
        said.append("whatever differs from run to run")
    return " or ".join(said)


def class_sentence(found: Found) -> str:
    """Friction, actuator, load or sensor."""
    effects = found.diagnosis.corrected.effects
    if not effects:
        return ""
    ports = ", ".join(f"{e.name}: {e.port}" for e in effects)
    return f"Kind of what was found: {ports}."
