"""Loads of a declared model that act beside what a record replaces, each under its own number."""

from __future__ import annotations

from collections.abc import Iterator

from ...applied_load import Load
from ...loads.ramp import RampOnCoordinate
from ...part import arguments_of
from ...problems import InvalidInput, Problem
from ...scenario import Scenario

#: How a load asks for what a controller holds.
HELD = ("held_", "at_")


def of_a_clock(load: Load) -> bool:
    """Whether a load does what it does by time, or by what a controller or a record tells it."""
    return bool({"time", "rec"} & _asked(load)) or bool(_held(load))


def check_beside(declared: Scenario, driven: Scenario) -> None:
    """Check that all loads but those which the record replaced can act as the record drives.

    Parameters
    ----------
    declared : Scenario
    driven : Scenario
        The same, driven by the record: a load stands where it was declared, or what replaced it.

    Raises
    ------
    InvalidInput
        With each load that is told what to do by a controller that is replaced, or goes by a time
        of its own, and each tolerance on a number of a load that was replaced.
    """
    problems = [*_refused(declared, driven), *_untold(declared, driven)]
    if problems:
        raise InvalidInput(problems)


def _refused(declared: Scenario, driven: Scenario) -> Iterator[Problem]:
    holds = {name for stage, _ in driven.controllers for name in stage.holds}
    for k, (load, now) in enumerate(zip(declared.loads, driven.loads, strict=False), 1):
        if now is not load:
            continue
        where, kind = f"load.{k}", type(load).__name__
        if not _held(load) <= holds:
            what = "nothing tells this load what to do as a record drives the model"
            right = "no such load in the model, or a recording of what it is told"
            yield Problem(declared.name, where, what, kind, right)
        elif "time" in _asked(load) and not _steady(load):
            what = "this load goes by a time of its own, and recorded runs began at others"
            yield Problem(declared.name, where, what, kind, "a constant one, or none")


def _untold(declared: Scenario, driven: Scenario) -> Iterator[Problem]:
    """Tolerances on what is no number of the driven model any more."""
    for group in declared.notes.get("tolerances", ()):
        for name in (n for n in group["parameters"] if n.startswith("load.")):
            _, number, field = name.split(".", 2)
            load, now = (each.loads[int(number) - 1] for each in (declared, driven))
            if now is not load and field not in now.parameters():
                what = f"a number of {type(load).__name__}, which the record takes the place of"
                where = f"tolerances: {group['name']}"
                yield Problem(declared.name, where, what, name, "no tolerance on it")


def _steady(load: Load) -> bool:
    """Whether what goes by time stays the same."""
    if isinstance(load, RampOnCoordinate):
        return load.slope == 0.0
    points = getattr(load, "points", None)
    return points is not None and len({tuple(row[1:]) for row in points}) == 1


def _asked(load: Load) -> set[str]:
    asked = {name for f in load.functions().values() for name in arguments_of(f)}
    return asked - load.parameters().keys()


def _held(load: Load) -> set[str]:
    """What controllers hold for a load, beside commands of clutches."""
    asked = _asked(load)
    return {name.removeprefix(p) for p in HELD for name in asked if name.startswith(p)}
