"""Rows of the own generator beside what a method study asked of such a diagnosis."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from statistics import median

from own_score import Row, ratio, size, told_unseen
from own_testbed_effects import KINDS

#: Scores that name what is not there.
WRONG = ("misnamed", "spurious", "named", "set named", "set without it")


def beside(rows: Sequence[Row]) -> list[list[object]]:
    """One line a measure: what was asked, what the study had, what came out, whether met."""
    lines = []
    for what, asked, study, measured in MEASURES:
        done = measured(rows)
        if done is not None:
            said, met = done
            word = "yes" if met else "**no**"
            lines.append([what, asked, study, said, word if asked else ""])
    return lines


Said = tuple[str, bool] | None


def _of(rows: Sequence[Row], group: str, strength: float | None = None) -> list[Row]:
    return [
        r for r in rows
        if r["group"] == group
        and (strength is None or max(r["hides"].values(), default=1.0) == strength)
    ]  # fmt: skip


def _tally(rows: Sequence[Row], share: float, most_wrong: int = 0) -> Said:
    """Right of all, and wrong names, against a share and a number."""
    if not rows:
        return None
    right = sum(r["score"] == "right" for r in rows)
    wrong = sum(r["score"] in WRONG for r in rows)
    met = right >= share * len(rows) and wrong <= most_wrong
    return f"{right} of {len(rows)}, {wrong} wrong", met


def _single(strength: float, share: float, most_wrong: int = 0) -> Callable[[Sequence[Row]], Said]:
    return lambda rows: _tally(_of(rows, "single", strength), share, most_wrong)


def _nulls(rows: Sequence[Row]) -> Said:
    if not (of := _of(rows, "null")):
        return None
    named = sum(r["score"] in WRONG for r in of)
    return f"{named} of {len(of)}", named == 0 and len(of) >= 100


def _without(rows: Sequence[Row]) -> Said:
    if not (of := _of(rows, "without")):
        return None
    named = sum(r["score"] == "named" for r in of)
    a_set = sum(r["score"] == "set named" for r in of)
    return f"{named} of {len(of)}, and {a_set} a set", named + a_set == 0


def _after(rows: Sequence[Row]) -> Said:
    """Kinds whose middle error is within 1.03, as the study counts them."""
    middles = []
    for name in KINDS:
        over = [
            x for r in _of(rows, "single") if name in r["hides"] and r["score"] == "right"
            if (x := ratio(r)) is not None
        ]  # fmt: skip
        middles += [median(over)] if over else []
    if not middles:
        return None
    close = sum(m <= 1.03 for m in middles)
    return f"{close} of {len(middles)} effects", close == len(middles)


def _said(rows: Sequence[Row]) -> Said:
    over = [r for r in _of(rows, "single") if (ratio(r) or 0.0) > 1.05]
    if not over:
        return None
    unsaid = sum(r["verdict"] == "effect" for r in over)
    return f"{len(over) - unsaid} of {len(over)}", unsaid == 0


def _sizes(rows: Sequence[Row]) -> Said:
    off = {}
    for name in KINDS:
        known = [
            x for r in _of(rows, "single") if name in r["hides"] and r["score"] == "right"
            if (x := size(r)) is not None
        ]  # fmt: skip
        if known:
            off[name] = median(known)
    if not off:
        return None
    far = [f"{n} {100 * x:.0f} %" for n, x in off.items() if x > 0.05]
    close = len(off) - len(far)
    return f"{close} of {len(off)}" + (f"; {', '.join(far)}" if far else ""), not far


def _pairs(rows: Sequence[Row], group: str) -> Said:
    return _tally(_of(rows, group), 7 / 8)


def _blind(rows: Sequence[Row]) -> Said:
    missed = [r for r in _of(rows, "poor") if r["score"] == "missed"]
    if not missed:
        return None
    told = sum(map(told_unseen, missed))
    return f"{told} of {len(missed)}", told >= 11 / 12 * len(missed)


def _advised(rows: Sequence[Row]) -> Said:
    return _tally(_of(rows, "advised"), 10 / 12)


def _plain(rows: Sequence[Row]) -> Said:
    if not (of := _of(rows, "poor")):
        return None
    wrong = sum(r["score"] in ("misnamed", "spurious") for r in of)
    return f"{wrong} of {len(of)}", wrong == 0


def _time(rows: Sequence[Row]) -> Said:
    middle = median(r["cpu_seconds"] for r in rows)
    return f"{middle:.0f} s", middle <= 9.0


MEASURES: tuple[tuple[str, str, str, Callable[[Sequence[Row]], Said]], ...] = (
    ("one effect, strength 1: named", "68 of 70, 0 wrong", "69, 0", _single(1.0, 68 / 70)),
    ("strength 0.6", "40 of 42, 0 wrong", "40, 0", _single(0.6, 40 / 42)),
    ("strength 0.35", "24 of 28, at most 1 wrong", "25, 0", _single(0.35, 24 / 28, 1)),
    ("nulls named", "0 of 100", "0 of 72", _nulls),
    ("named with the right effect out of the library", "0", "0 of 112", _without),
    ("in nobody's list: unknown, with its coordinate", "90 %, 0 wrong", "33 of 36",
     lambda rows: _tally(_of(rows, "outside"), 0.9)),
    ("error after at most 1.03 of the floor", "every right form", "10 of 14 effects", _after),
    ("above 1.05: told", "always", "22 of 25", _said),
    ("size within 5 %", "every effect", "", _sizes),
    ("two effects, both named", "7 of 8, 0 wrong", "", lambda rows: _pairs(rows, "pair")),
    ("two effects that were drawn", "", "", lambda rows: _pairs(rows, "drawn")),
    ("one-way runs: what was missed is listed as unseen", "11 of 12", "", _blind),
    ("named after the run that was asked for", "10 of 12", "", _advised),
    ("one-way runs: a wrong name", "none", "5 of 6", _plain),
    ("processor time", "about 9 s", "9 s", _time),
)  # fmt: skip
