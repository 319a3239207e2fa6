"""Counts in the README are typed: each is taken from the table that it speaks of once more."""

import csv
from collections import Counter
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
TEXT = " ".join((ROOT / "README.md").read_text(encoding="utf-8").split())


def rows(name: str) -> list[dict[str, str]]:
    with (ROOT / "benchmarks" / name).open(encoding="utf-8", newline="") as handle:
        return list(csv.DictReader(handle))


def own(group: str, strength: str = "", column: str = "score") -> Counter[str]:
    """Scores of a group of the own generator's cases; ``first_score``: when first run."""
    some = [r for r in rows("diagnose_own.csv") if r["group"] == group]
    return Counter(r[column] for r in some if f"@{strength}" in r["case"] or not strength)


def of(scores: Counter[str], score: str = "right") -> str:
    return f"{scores[score]} of {scores.total()}"


def own_testbed() -> list[str]:
    without, poor, advised = own("without"), own("poor"), own("advised")
    single = [own("single", f"{s}.") for s in ("1", "0.6", "0.35")]
    named = [r for r in rows("diagnose_own.csv") if (r["group"], r["score"]) == ("single", "right")]
    near = sum(float(r["after_over_floor"]) <= 1.03 for r in named if r["after_over_floor"])
    first = {g: own(g, column="first_score")["right"] for g in ("pair", "outside", "without")}
    programs = {r["commit"] for r in rows("diagnose_own.csv")}
    return [
        f"({len(programs)} for the {len(rows('diagnose_own.csv'))} cases)",
        f"at most 1.03 in {near} of",
        f"{of(own('null'))} | strength 1: right {of(single[0])}",
        f"0.6: {of(single[1])}; 0.35: {of(single[2])}",
        f"values declared far off {of(own('declared'))}",
        f"pairs {of(own('pair'))} ({first['pair']}); drawn pairs {of(own('drawn'))}",
        f"unknown {of(own('outside'))} ({first['outside']}); with the right effect taken out "
        f"{of(without)} ({first['without']})",
        f"taken out of the library, {of(without, 'named')} is given a name",
        f'{without["missed"]} are "nothing missing"',
        f'and {without["unknown"]} "unknown" without the variable',
        f"{poor['right']} right, {poor['set with it']} in a set, {poor['unknown']} unknown, "
        f"{poor['missed']} not seen",
        f"{advised['right']} of the {advised.total()} are right",
    ]


def one_coordinate() -> list[str]:
    slides, motors = rows("own_axis.csv"), rows("own_motor.csv")
    tables = (slides, motors, rows("own_pendulum.csv"))
    nulls = [Counter(r["score"] for r in t if r["kind"].startswith("null")) for t in tables]
    said = [of(every) for every in nulls]
    resting = [[r for r in some if r["kind"].startswith("by-rest")] for some in (slides, motors)]
    wrong = [[r for r in some if r["score"] == "misnamed"] for some in resting]
    left = [float(r["after_over_floor"]) for r in (*wrong[0], *wrong[1])]
    return [
        f"| {said[0]}, \"lack or noise\" {nulls[0]['lack or noise']} |",
        f"| {said[1]} | right", f"| {said[2]} | right",
        f"misnamed on {len(wrong[0])} of {len(resting[0])} slides",
        f"leave {left[0]:.0f} times the floor",
        f"and on {len(wrong[1])} of {len(resting[1])} motors",
        f"at {left[1]:.1f} and {left[2]:.1f} times the floor",
    ]  # fmt: skip


def sealed() -> list[str]:
    every = [r for side in ("testbed", "robot") for r in rows(f"verdicts_{side}_sealed.csv")]
    verdicts = Counter(r["verdict"] for r in every)
    named = [r for r in every if r["verdict"] in ("effect", "form incomplete")]
    close = sum(float(r["after_over_floor"]) <= 1.05 for r in named)
    return [
        f"named {len(named)}, not to be told apart {verdicts['cannot be told apart']}, "
        f"unknown {verdicts['unknown']}, nothing missing {verdicts['nothing missing']}; "
        f"after at most 1.05 in {close} of {len(named)}"
    ]


@pytest.mark.parametrize("made", [own_testbed, one_coordinate, sealed])
def test_readme_counts_what_its_tables_hold(made):
    absent = [phrase for phrase in made() if phrase not in TEXT]
    assert not absent, absent
