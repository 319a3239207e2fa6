"""docs/own-generator.md from the rows of the own generator."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import accumulate
from statistics import median

from own_cases import COMMONEST, NOISES, STRENGTHS, WEAKER, cases
from own_measures import beside
from own_score import Row, ratio, size, told_unseen
from own_testbed_effects import KINDS

SCORES = (
    "right", "set with it", "part", "unknown", "missed", "misnamed", "spurious", "set without it",
    "named", "set named",
)  # fmt: skip
EVERY = (*STRENGTHS, *WEAKER)
GROUPS = (
    "null", "single", "pair", "drawn", "outside", "without", "declared", "poor", "advised",
)  # fmt: skip


def summary(rows: Sequence[Row]) -> list[list[object]]:
    """One line a group, strength and noise: how many of each score."""
    lines = []
    for group in GROUPS:
        for strength in EVERY:
            for noise in NOISES:
                of = [
                    r for r in rows
                    if r["group"] == group and r["noise"] == noise
                    and max(r["hides"].values(), default=1.0) == strength
                ]  # fmt: skip
                if of:
                    tally = Counter(r["score"] for r in of)
                    named = "-" if group == "null" else f"{strength:g}"
                    counts: list[object] = [tally[s] or "" for s in SCORES]
                    if unseen := sum(map(told_unseen, of)):
                        counts[SCORES.index("missed")] = f"{tally['missed']} ({unseen})"
                    lines.append([group, named, noise, len(of), *counts])
    return lines


def changed(rows: Sequence[Row]) -> list[list[object]]:
    """Cases on which another verdict was scored when they were first run."""
    return [
        [r["group"], f"{max(r['hides'].values(), default=1.0):g}", r["case"], r["first_score"],
         r["score"]]
        for r in rows
        if r["first_score"] != r["score"]
    ]  # fmt: skip


def by_effect(rows: Sequence[Row]) -> list[list[object]]:
    """Right of all, at each strength."""
    lines, rich = [], [r for r in rows if r["group"] in ("single", "pair", "outside")]
    for name, kind in KINDS.items():
        if not any(name in r["hides"] for r in rich):
            continue
        line: list[object] = [name]
        for strength in STRENGTHS:
            of = [r for r in rich if r["hides"] == {name: strength}]
            right = sum(r["score"] == "right" for r in of)
            wrong = sum(r["score"] in ("misnamed", "spurious", "named") for r in of)
            line.append(
                f"{right} of {len(of)}" + (f", {wrong} wrong" if wrong else "") if of else ""
            )
        over = [ratio(r) for r in rich if name in r["hides"] and r["score"] == "right"]
        sizes = [size(r) for r in rich if r["hides"].keys() == {name} and r["score"] == "right"]
        measured = [s for s in sizes if s is not None]
        line.append(f"{median(over):.3f}" if over and kind.names else "")
        line.append(f"{100 * median(measured):.0f} %" if measured else "")
        lines.append(line)
    return lines


def limits(rows: Sequence[Row]) -> list[list[object]]:
    """How weak the commonest effects may be: the error over the floor, and what was said."""
    lines = []
    for name in COMMONEST:
        line: list[object] = [name]
        for strength in EVERY:
            of = [r for r in rows if r["group"] == "single" and r["hides"] == {name: strength}]
            shown = [f"{r['refitted'] / r['floor']:.3f} {r['score']}" for r in of if "floor" in r]
            line.append("; ".join(shown))
        if any(line[-len(WEAKER) :]):
            lines.append(line)
    return lines


def _markdown(head: Sequence[object], lines: Sequence[Sequence[object]]) -> str:
    return "\n".join(
        "| " + " | ".join(str(x) for x in line) + " |"
        for line in [head, ["---"] * len(head), *lines]
    )


def _within(rows: Sequence[Row], seconds: float) -> int:
    """How many cases, from the beginning of the list, take no more CPU than that."""
    cost = {r["case"]: r["cpu_seconds"] for r in rows}
    every = accumulate(cost[c.name] for c in cases() if c.name in cost)
    return sum(spent <= seconds for spent in every)


def page(rows: Sequence[Row], matrix: tuple[list[str], list[str], list[list[int]]]) -> str:
    """docs/own-generator.md."""
    truths, said, counts = matrix
    nulls = [r for r in rows if r["group"] == "null"]
    named = sum(r["score"] == "named" for r in nulls)
    right = [r for r in rows if r["group"] == "single" and r["score"] == "right"]
    over = [x for x in map(ratio, right) if x is not None]
    unsaid = sum(ratio(r) > 1.05 for r in rows if r["verdict"] == "effect")  # type: ignore[operator]
    cpu = [r["cpu_seconds"] for r in rows]
    programs = Counter(r["commit"] for r in rows)
    facts = [
        f"{len(rows)} of {len(cases())} cases are done, by {len(programs)} programs.",
        f"Nulls named: {named} of {len(nulls)}.",
    ]  # fmt: skip
    if over:
        close = sum(x <= 1.03 for x in over)
        facts.append(
            f"Error after, over the floor, where the name is right: median {median(over):.3f}, "
            f"at most 1.03 in {close} of {len(over)}; above 1.05 without a word in {unsaid}."
        )
    if cpu:
        facts.append(f"CPU time of a diagnosis: median {median(cpu):.0f} s, most {max(cpu):.0f} s.")
        facts.append(
            f"These cases take {sum(cpu) / 3600.0:.0f} hours of CPU; four hours of two cores make "
            f"the first {_within(rows, 2 * 4 * 3600.0)} of the list."
        )
    matrix_text = _markdown(
        ["hidden", *said],
        [[t, *(c or "" for c in line)] for t, line in zip(truths, counts, strict=True)],
    )
    return "\n".join([
        ABOUT, *[f"- {fact}" for fact in facts], "", "## Beside the method study", "", STUDY, "",
        _markdown(["", "asked", "the study's own", "here", "met"], beside(rows)), "",
        "## By group", "",
        _markdown(["group", "strength", "noise", "cases", *SCORES], summary(rows)), "",
        FIRST, "", _markdown(["group", "strength", "case", "at first", "now"], changed(rows)), "",
        "## By effect", "", _markdown(
            ["hidden", "strength 1", "0.6", "0.35", "after/floor", "error of size"],
            by_effect(rows)), "",
        SIZES,
        *_limits_text(rows), "", "## What was said of what", "", matrix_text, "",
        "![confusion](own-generator.png)", "", "Cases by the program at "
        + ", ".join(f"{c} ({n})" for c, n in programs.items()) + ".", "",
    ])  # fmt: skip


def _limits_text(rows: Sequence[Row]) -> list[str]:
    lines = limits(rows)
    if not lines:
        return []
    head = ["hidden", *(f"{strength:g}" for strength in EVERY)]
    return ["", "## How weak an effect may be", "", LIMITS, "", _markdown(head, lines)]


LIMITS = """Error over the floor after the declared parameters were refitted, which is all that a
recording shows of what is hidden, and whether the verdict is right; one entry for each
recording."""


SIZES = """For an effect in nobody's list, right is: unknown, with a coordinate that belongs to it.
Errors of size are those of numbers that have the same name in the generator and the
library: an own drag grows with the 1.1th power of speed (at 2 rad/s 7 % more than in
proportion), an own Stribeck fades with an exponent of 1.3, an own slow release depends
on the excitation."""

STUDY = """A study of methods, with data of a generator of its own and 14 effects, asked for the
following from whoever builds such a diagnosis. The numbers in "the study's own" are of
its prototype."""

FIRST = """Counts above are of the latest run of each case. A case is unseen when it is first run.
Where rules were changed since, and a case was run again with another score, both scores
stand here (a rule may have been made on it)."""

ABOUT = """# Recordings of another generator

    python benchmarks/diagnose_own.py --hours 4
    python benchmarks/own_testbed.py DIR --seed 1 --effects stribeck=1 imbalance=0.6

`benchmarks/own_testbed*.py` makes recordings of the testbed with the plan of the practice files. It
shares no code with the package: it has steps of 50 us, a rule for stick of its own, and forms that
are not those of the library (an exponent of 1.3 for Stribeck, two time constants of heat, five
plays, harmonics beyond the second, a soft limit of the supply, four springs that yield in turn, a
play with hard ends). Six effects are in nobody's list; backlash was there until the library had it.
At strength 1 the residual after the refit is 1.1 to 3 times the floor, as in the practice files.
Half of the recordings have coloured noise (60 % of its variance with a correlation time of 20 ms).

- `drawn`: two effects of the library drawn at random, each of strength 1 or 0.6 (a line of the
  table goes by the stronger).
- `without`: recordings of strength 1, diagnosed with every right name taken out of the library;
  right is "unknown".
- `poor`: one-way runs in which the motor's torque was not logged; in brackets how many of the
  missed ones the diagnosis itself lists as what these runs cannot show.
- `advised`: the same rig with the runs made that the diagnosis of the poor recording puts first,
  both torques logged in them.

Each case has its seed from its name. The list is ordered so that any beginning of it is a fair
part. This page is written by the command.
"""
