"""The loop closed: diagnose, correct, diagnose again, run the thesis's line with what was found.

    python benchmarks/closed_loop.py [--size N]

writes docs/closed-loop.md and docs/closed-loop.png.  The recordings are the synthetic practice
files of the testbed (SIMPTER_DATA); what is found on its one clutch is put on all four clutches of
the linkage.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, replace
from pathlib import Path

from measured import DATA

from simpter_hybrid.effect import Effect
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.result import Diagnosis, corrected
from simpter_hybrid.plots.style import png
from simpter_hybrid.rigs.inputs import Inputs
from simpter_hybrid.rigs.line import line
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.studies.page import section, table_lines
from simpter_hybrid.studies.study import Study, Table
from simpter_hybrid.studies.variants import (
    ABOUT,
    comparison,
    ratio_picture,
    ratios,
    side_by_side,
    verdict,
)

HERE = Path(__file__).resolve().parent
DOCS = HERE.parent / "docs"
PRACTICE = ("hyst", "slewsat", "stribeck")
DECLARED = "as declared"
LAG = "time constant"
CLUTCHES = 4
ABOUT_PAGE = (
    "Each of these synthetic recordings of the thesis's testbed (one clutch) holds one effect that "
    "the declared model lacks. `simpter diagnose` is run on the recording, and then once more with "
    "the corrected model that it wrote. After that, the effect that was found is put on all four "
    "clutches of PTER, and the thesis's line y = 24 in is run with it and without it."
)
LEFT_OUT = (
    "The effect has the size that was fitted on the testbed. The factors in the table above are "
    "not carried over: they belong to one specimen, while the clutches of the linkage keep (39) "
    "and (43) as printed, and a time constant drawn from its plausible range. So two runs of a "
    "pair differ by the effect alone. (A slew limit takes the place of a part of the lag: with it, "
    "the factor on the time constant comes along.) On these clutches the effect is an example, not "
    "a measurement of theirs."
)
SIZE = 24


@dataclass(frozen=True)
class Loop:
    """One recording: what was found, and what a diagnosis of the corrected model finds."""

    found: Diagnosis
    again: Diagnosis

    @property
    def effects(self) -> tuple[Effect, ...]:
        """What was found on the testbed's clutch, with its fitted values."""
        model = self.found.search.corrected
        return tuple(x for e in model.effects for x in e.made(model.values) if x.clutch == 0)

    @property
    def lag(self) -> float:
        """Factor on the time constant that an effect replaces, as a slew limit does; else 1."""
        model = self.found.search.corrected
        replaced = {p.name for e in model.effects for p in e.parameters}
        return model.values[LAG] if LAG in replaced else 1.0

    @property
    def name(self) -> str:
        """Names of the effects."""
        return " and ".join(e.name for e in self.found.search.corrected.effects)


def closed(file: str) -> Loop:
    """Diagnose a recording against the declared testbed, then against the corrected one."""
    declared = load(find_model("testbed"))
    path = DATA / "testbed" / "practice" / f"{file}.csv.gz"
    recording = load_recording(path, MAPS / "testbed.toml")
    found = diagnose(recording, declared)
    return Loop(found, diagnose(recording, corrected(found, f"{file}-corrected")))


def with_effects(
    kind: str, gain: float, x: Inputs, effects: tuple[Effect, ...], lag: float
) -> Scenario:
    """The thesis's line with effects on all four clutches, and `lag` times their time constant."""
    added = tuple(replace(e, clutch=i) for i in range(CLUTCHES) for e in effects)
    scenario = line(kind, gain, x)
    clutches = tuple(replace(c, time_constant=lag * c.time_constant) for c in scenario.clutches)
    return scenario.replace(effects=added, clutches=clutches)


def study(loops: dict[str, Loop], size: int) -> Study:
    """What the corrections change in the thesis's scenario."""
    variants: dict[str, tuple[tuple[Effect, ...], float]] = {DECLARED: ((), 1.0)}
    variants |= {loop.name: (loop.effects, loop.lag) for loop in loops.values()}
    found = side_by_side(
        {
            name: lambda kind, gain, x, its=added: with_effects(kind, gain, x, *its)
            for name, added in variants.items()
        },
        size,
    )
    names = [name for name in variants if name != DECLARED]
    told = tuple(
        f"With {name}, the error is smaller in this share of the pairs: "
        f"{verdict(found, name, DECLARED, 'error')}; the jerk in: "
        f"{verdict(found, name, DECLARED, 'jerk')}."
        for name in names
    )
    return Study(
        "The loop closed: what a found effect changes in the thesis's scenario",
        "thesis 4 and 5; synthetic recordings of the testbed (practice files)",
        f"{ABOUT.format(size=size)} {LEFT_OUT}",
        (comparison(found, DECLARED, "On the line, nominal inputs, and over all pairs"),),
        told,
        {"ratios": ratios(found, DECLARED)},
        ratio_picture(found, DECLARED, "Corrected models, against the one declared"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )


def ladder(loops: dict[str, Loop]) -> Table:
    """Verdicts, errors before and after on runs that had no part in it, and the second verdict."""
    rows = []
    for file, loop in loops.items():
        at = loop.found.error_by_stage
        rows.append(
            (
                file,
                verdict_sentence(loop.found),
                *(f"{at[k]:.3f}" for k in ("declared", "refitted", "after", "floor")),
                verdict_sentence(loop.again),
            )
        )
    return Table(
        "Errors are of runs held out, in units of the noise",
        (
            "recording",
            "diagnosis of the declared model",
            "declared",
            "refitted",
            "after",
            "floor",
            "diagnosis of the corrected model",
        ),
        tuple(rows),
    )


def refits(loops: dict[str, Loop]) -> Table:
    """By what the declared parameters were multiplied beside the effect, which stays there."""
    names = [group["name"] for group in load(find_model("testbed")).notes["tolerances"]]
    rows = []
    for file, loop in loops.items():
        values = loop.found.search.corrected.values
        rows.append((file, *(f"{values[name]:.3f}" for name in names)))
    return Table(
        "The corrected model also has these factors on what was declared",
        ("recording", *names),
        tuple(rows),
    )


def main() -> None:
    """Write the page and its picture."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--size", type=int, default=SIZE, help="sets of plausible inputs")
    args = parser.parse_args()
    loops = {file: closed(file) for file in PRACTICE}
    made = study(loops, args.size)
    assert made.picture is not None
    (DOCS / "closed-loop.png").write_bytes(png(made.picture()))
    size = "" if args.size == SIZE else f" --size {args.size}"
    lines = [
        f"# {made.title}", "", f"Made by `python benchmarks/closed_loop.py{size}`.", "",
        ABOUT_PAGE, "", "## Found, corrected, diagnosed again", "",
        *table_lines(ladder(loops)), *table_lines(refits(loops)),
        "## What the effect changes on the line", "", *section(made, "closed-loop.png"),
    ]  # fmt: skip
    (DOCS / "closed-loop.md").write_text("\n".join(lines), encoding="utf-8")


if __name__ == "__main__":
    main()
