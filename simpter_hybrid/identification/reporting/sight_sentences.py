"""What runs do not show and which run would, in sentences."""

from __future__ import annotations

from collections.abc import Sequence

from ..fitting.predictor import Candidate
from ..identifiability_report import Sight
from ..identifiability_request import forms_asked
from ..result import Diagnosis

#: A class is named in place of its effects where it has more than so many, and at most one in so
#: many of them is not meant.
FEW = 3
#: Questions that are asked at once.
ASKED = 4


def in_classes(names: Sequence[str], candidates: Sequence[Candidate]) -> list[str]:
    """Names of effects, with a class of which (nearly) all are meant named instead.

    Parameters
    ----------
    names : sequence of str
    candidates : sequence of Candidate
        The library.
    """
    said, left = [], list(names)
    for place in dict.fromkeys(c.acts_on for c in candidates):
        every = [c.name for c in candidates if c.acts_on == place and c.listed]
        others = [name for name in every if name not in names]
        if len(every) > FEW and len(others) <= len(every) // FEW:
            but = f" (but not {', '.join(others)})" if others else ""
            said.append(f"every {place} effect{but}")
            left = [name for name in left if name not in every]
    return [*said, *left]


def blind_sentence(blind: Sequence[str]) -> str:
    """Sentence on what the data would not show if it were missing; "" if they show all."""
    if not blind:
        return ""
    return (
        "If small (some per cent of friction, or of the largest force) these would not show in "
        f"these data: {', '.join(blind)}."
    )


def next_sentence(found: Diagnosis, sight: Sight | None) -> str:
    """Sentence on the run that would tell what was named from what contests it; "" if nothing does.

    That is a rival, or a declared value that is a form of what was named.
    """
    contested = found.search.verdict.kind == "cannot be told apart"
    forms = {(a.candidate.name, b.candidate.name) for a, b in forms_asked(found.search)}
    if sight is None or found.experiments is None or not (contested or forms):
        return ""
    named = {e.listed_as: e.name for e in found.search.corrected.effects}
    rivals = {r.candidate.listed_as: r.candidate.name for r in found.search.verdict.rivals}
    said = []
    for pair, runs in sight.run_next.items():
        if pair[0] not in named or not runs or not (contested or pair in forms):
            continue
        (name, distance), question = (
            runs[0],
            f"tell {named[pair[0]]} from {rivals.get(pair[1], pair[1])}",
        )
        apart = f"{deviations(distance)} standard deviations of the noise apart"
        far = f"{apart}; {deviations(sight.needed[name])} are needed"
        others = otherwise(pair, sight, found.candidates)
        if others:
            nearest = f" ({name}: {far})" if round(distance) else ""  # a run of distance 0 is none
            said.append(f"No planned run would {question}{nearest}. Instead: {' '.join(others)}")
        else:
            said.append(f"Run next, to {question}: {name} ({far}).")
    more = len(said) - ASKED
    return " ".join(said[:ASKED]) + (
        f" {more} more questions are in the report." if more > 0 else ""
    )


def deviations(distance: float) -> str:
    """So many standard deviations, to the digits that decide."""
    return f"{distance:.2g}" if distance < 10.0 else f"{distance:.3g}"


def otherwise(
    pair: tuple[str, str], sight: Sight, candidates: Sequence[Candidate]
) -> tuple[str, ...]:
    """Experiments in words that would tell two effects apart, where no planned run would."""
    if any(distance >= sight.needed[name] for name, distance in sight.run_next[pair]):
        return ()
    told = {c.name: c.experiment for c in candidates}
    return tuple(dict.fromkeys(told[name] for name in pair if told.get(name)))
