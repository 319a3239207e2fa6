"""Kinds of runs that a refit, or what was found, makes far worse for the sake of others."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from ..result import Diagnosis
from ..run_levels import differs
from .kinds_of_runs import Errors, Runs, far_ones, of_kinds
from .run_errors import spoilt_sentence

#: A kind is far worse that ends twice as far above the floor as it was, and at twice the floor at
#: least.  A friction that warmed through moved a slip torque by 13 %: kinds of runs at 1.2 and 1.5
#: times the floor came to 4.9 and 2.6, the other nine rose by a sixth at most.  A mere ratio of
#: errors would ask less of what is far off than of what is near.
FARTHER, ABOVE = 2.0, 2.0
#: Kinds that are listed.
LISTED = 4


def spoilt_told(found: Diagnosis, errors: Errors, runs: Any) -> str:
    """What a refit, or what was found, spoils: most runs, else some kinds of them; else "".

    Parameters
    ----------
    found : Diagnosis
    errors : mapping of str to mapping of str to float
        As of `errors_of_experiments`.
    runs : mapping of str to list of mapping
        As of `errors_of_runs`.
    """
    if found.ruling_run is not None:  # whose sentence asks about it
        return ""
    return spoilt_sentence(runs) or spoilt_kinds_sentence(found, errors, runs)


def spoilt_kinds_sentence(found: Diagnosis, errors: Errors, runs: Runs) -> str:
    """Which kinds of runs are far worse refitted, or with what was found; "" if none is.

    Of a kind that is held out these runs count: what is worse in fitted runs alone was chosen so.
    Parameters as of `spoilt_told`.
    """
    if found.levels and all(map(differs, found.levels)):  # runs held out have the common value
        return ""
    every = {**_of_stages(runs), **errors}
    told = far_ones(found, errors, runs)  # by `uneven_sentence`
    by: dict[str, list[tuple[float, str]]] = {"declared": [], "refitted": []}
    for name, e in every.items():
        stage = "declared" if _far_worse(e, "declared", "refitted") else "refitted"
        if name not in told and _far_worse(e, stage, "after"):
            text = f"{name} {e[stage]:.3g} to {e['after']:.3g}"
            by[stage].append((e["after"] / e[stage], text))
    said = []
    if by["declared"]:
        said.append(
            f"Some kinds of runs are far worse refitted than as declared ({_listed(by['declared'])}"
            " times the floor): the refit makes up for what is missing in others, and its numbers "
            "are no measurement."
        )
    if by["refitted"] and found.search.corrected.effects:
        said.append(
            "Some kinds of runs are far worse with what was found than without it "
            f"({_listed(by['refitted'])} times the floor): it acts otherwise there."
        )
    return " ".join(said)


def _of_stages(runs: Runs) -> dict[str, dict[str, float]]:
    """Kind of runs that fit or select -> stage -> error over the floor, of the worse part."""
    stages = ("declared", "refitted", "after")
    apart = {stage: of_kinds(runs, stage) for stage in stages}
    return {name: {s: apart[s][name] for s in stages} for name in apart["after"]}


def _far_worse(errors: Mapping[str, float], before: str, after: str) -> bool:
    """Whether one stage leaves far more than another."""
    if not {before, after} <= errors.keys() or not errors[before] > 0.0:  # it failed there
        return False
    floor = errors.get("floor", 1.0) or 1.0
    rise = errors[after] - floor
    return errors[after] > ABOVE * floor and rise > FARTHER * max(errors[before] - floor, 0.0)


def _listed(found: Sequence[tuple[float, str]]) -> str:
    """Words on those that are worst."""
    worst = [text for _, text in sorted(found, reverse=True)]
    more = len(worst) - LISTED
    return ", ".join(worst[:LISTED]) + (f" and {more} more" if more > 0 else "")
