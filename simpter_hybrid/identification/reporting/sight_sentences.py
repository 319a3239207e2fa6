"""What runs do not show and which run would, in sentences."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from ..fitting.predictor import Candidate
from ..identifiability_report import Sight
from ..identifiability_request import forms_asked
from ..result import Diagnosis
from ..tracing.limits import IMPERFECT

#: A class is named in place of its effects where it has more than so many, and at most one in so
#: many of them is not meant.
FEW = 3
#: Sentences that are told at once; experiments told for what the runs do not show.
ASKED, SHOWN = 4, 3

#: Names of two effects.
Pair = tuple[str, str]

#: A run as it was recorded may be asked for: whole it tells what its pieces, begun anew, do not.
WHOLE = " It has to be followed whole: not cut into pieces, as these data are."


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


def blind_sentence(
    blind: Sequence[str],
    shown: Mapping[str, Sequence[str]] | None = None,
    visible: Sequence[str] | None = None,
) -> str:
    """Sentence on what the data would not show if it were missing; "" if they show all.

    Parameters
    ----------
    blind : sequence of str
        Effects, or classes of them.
    shown : mapping of str to sequence of str, optional
        Experiment -> effects of these that it would show.
    visible : sequence of str, optional
        What the data do show, to be told in place of all else where that is shorter.
    """
    if not blind:
        return ""
    runs = [f"to see {_few(effects)}: {name}" for name, effects in (shown or {}).items()]
    asked = f" Run next, {'; '.join(runs)} (what is laid down stands in the report)."
    small = "If small (some per cent of friction, or of the largest force)"
    if visible is not None and len(visible) < len(blind):
        but = f" but {_listed(in_series(visible))}" if visible else ""
        told = f"{small} no effect of the library{but} would show in these data."
    else:
        told = f"{small} these would not show in these data: {', '.join(in_series(blind))}."
    return f"{told}{asked if runs else ''}"


def _few(names: Sequence[str]) -> str:
    """The first of these, and how many more there are."""
    more = [f"{len(names) - FEW} more"] if len(names) > FEW else []
    return _listed([*names[:FEW], *more])


def in_series(names: Sequence[str]) -> list[str]:
    """Names of which those that differ by a number that counts up are one: "ripple-3 to -8"."""
    series: dict[str, list[int]] = {}
    for name in names:
        base, _, number = name.rpartition("-")
        if base and number.isdigit():
            series.setdefault(base, []).append(int(number))
    said: dict[str, None] = {}
    for name in names:
        base, _, number = name.rpartition("-")
        of = sorted(series.get(base, ())) if number.isdigit() else []
        follow = len(of) >= FEW and of == list(range(of[0], of[0] + len(of)))
        said[f"{base}-{of[0]} to -{of[-1]}" if follow else name] = None
    return list(said)


def asked_of_runs(found: Diagnosis, sight: Sight | None) -> dict[tuple[str, str], list[Pair]]:
    """Questions by what was named and the experiment that settles them; "" where none does.

    What was named is contested by a rival, or by a declared value that is a form of it.
    """
    contested = found.search.verdict.kind == "cannot be told apart"
    forms = {(a.candidate.name, b.candidate.name) for a, b in forms_asked(found)}
    if sight is None or found.experiments is None or not (contested or forms):
        return {}
    named = {e.listed_as for e in found.search.corrected.effects}
    # What one run tells, and all that none does, is one sentence.
    asked: dict[tuple[str, str], list[Pair]] = {}
    for pair, runs in sight.run_next.items():
        if pair[0] in named and pair[1] not in named and runs and (contested or pair in forms):
            tells = not otherwise(pair, sight, found.candidates)
            asked.setdefault((pair[0], runs[0][0] if tells else ""), []).append(pair)
    return asked


def shown_by(sight: Sight | None, effects: Collection[str]) -> dict[str, list[str]]:
    """Few experiments that show most of the effects to which the runs that were made are blind."""
    if sight is None or not sight.planned:
        return {}
    shows: dict[str, list[str]] = {}
    for effect, ((name, distance), *_) in sight.reveals.items():
        if effect in effects and distance >= sight.needed[name]:
            shows.setdefault(name, []).append(effect)
    order = sorted(shows, key=lambda name: -len(shows[name]))  # of equals the first stays first
    return {name: shows[name] for name in order[:SHOWN]}


def advised(found: Diagnosis, sight: Sight | None, unseen: Collection[str]) -> tuple[str, ...]:
    """Experiments that sentences ask for, in their order."""
    first = [name for _, name in list(asked_of_runs(found, sight))[:ASKED] if name]
    return tuple(dict.fromkeys([*first, *shown_by(sight, unseen)]))


def next_sentence(
    found: Diagnosis, sight: Sight | None, words: Mapping[str, str] | None = None
) -> str:
    """Lines on the runs that would tell what was named from what contests it; "" if nothing does.

    Parameters
    ----------
    found : Diagnosis
    sight : Sight or None
    words : mapping of str to str, optional
        Of each experiment how long it lasts and how far it goes.
    """
    asked = asked_of_runs(found, sight)
    if sight is None or not asked:
        return ""
    named = {e.listed_as: e.name for e in found.search.corrected.effects}
    rivals = {r.candidate.listed_as: r.candidate.name for r in found.search.verdict.rivals}
    # The unit of `seen_by`: 1 where deviations are those of the noise.
    far = IMPERFECT * found.search.floor < found.search.corrected.select_error < 1.0
    unit = "of what the model leaves" if far else "of the noise"
    cut = found.recording is not None and found.recording.map.pieces > 1
    said: list[str] = []
    for (effect, name), every in asked.items():
        # Those that the verdict names; where it says by what others go, a few.
        pairs = [pair for pair in every if pair[1] in rivals] or every[:FEW]
        more = f" (and {len(every) - len(pairs)} more)" if len(every) > len(pairs) else ""
        others = _listed([rivals.get(pair[1], pair[1]) for pair in pairs])
        question = f"tell {named[effect]} from {others}{more}"
        if name:
            takes = f" It takes {words[name]}." if words and name in words else ""
            takes += WHOLE if cut and not said else ""
            said.append(f"Run next, to {question}: {name} ({_apart(pairs, sight, unit)}).{takes}")
            continue
        (first, distance), *_ = sight.run_next[pairs[0]]
        told = len(pairs) == 1 and round(distance)  # a run of distance 0 is none
        nearest = f" ({first}: {_apart(pairs, sight, unit)})" if told else ""
        instead = (one for pair in pairs for one in otherwise(pair, sight, found.candidates))
        told_by = " ".join(dict.fromkeys(instead))
        said.append(f"No planned run would {question}{nearest}. Instead: {told_by}")
    further = sum(len(pairs) for pairs in list(asked.values())[ASKED:])
    are = "question is" if further == 1 else "questions are"
    rest = [f"{further} more {are} in the report."] if further else []
    return "\n".join([*said[:ASKED], *rest])


def _apart(pairs: Sequence[Pair], sight: Sight, unit: str) -> str:
    """How far the first run of each pair tells it apart, and how far it has to."""
    name, _ = sight.run_next[pairs[0]][0]
    far = _listed([deviations(sight.run_next[pair][0][1]) for pair in pairs])
    needed = deviations(sight.needed[name])
    return f"{far} standard deviations {unit} apart; {needed} are needed"


def _listed(words: Sequence[str]) -> str:
    *first, last = words
    return f"{', '.join(first)} and {last}" if first else last


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
