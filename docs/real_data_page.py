"""Write docs/real-data.md from the tables that the benchmarks wrote.

    python docs/real_data_page.py [--check]

``--check`` only says whether the page is fresh.
"""

from __future__ import annotations

import csv
import sys
from collections.abc import Iterator
from pathlib import Path

from simpter_hybrid.engine import simulate
from simpter_hybrid.reproduce.pictures import pictures

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "real-data.md"
STAGES = ("declared", "refitted", "after", "with it", "published model")
LEAD = """# Measured data, diagnosed

This page shows recordings that others made on real rigs, and what `simpter diagnose` makes of them.
A rig is a model (`identification/models/NAME.toml`) and a map (`identification/maps/NAME.toml`,
both below `simpter_hybrid/`).

The data do not come with the program. They are published recordings of EMPS (A. Janot, M. Gautier,
M. Brunot 2019), of a servo on a pendulum (Rhoban's BAM; Duclusaud et al. 2025), of pneumatic seals
(E. Zillen, TU Delft) and of DFKI's torque-limited simple and double pendulums, here as CSV with a
header of SI units. `SIMPTER_DATA` is the folder that holds `emps/`, `bam_xl330/` and so on.

The map states which runs fit, select and are held out; it follows the data's own suggestion.
Held-out runs choose nothing: they are reported on, and may take a name back. Models and maps were
settled on the runs that fit and select. One model was changed there: the pendulum's, from a
published fit to masses and lengths, because the refit ran into its bounds.

    simpter diagnose $SIMPTER_DATA/emps/data.csv.gz --model emps
    python benchmarks/real_recordings.py                       # makes the table below
    python docs/real_data_page.py                              # makes this page

Errors are on held-out runs. "After": with what the verdict names. Where it names nothing this is
the refitted model, and the best single candidate stands beside it although it is not believed.
"Published": the authors' own parameters under the same measure. Speeds, or positions where no speed
was recorded, are predicted in windows of 0.5 s that start from the record; from positions the
straight line that an error of the start leaves is taken away.

Runs were repeated on two rigs: runs 9 and 10 of the double pendulum, and one seal, whose tester
moved at another pace each time, so that no two of its runs are row by row the same. So the floor is
that of the sensors alone, no model of a real rig reaches it, and a form is never called complete.
"""
PARAGRAPHS = {
    "emps": """\
**Positioning axis (EMPS).** Declared: mass, Coulomb and viscous friction, the same both ways.
Named: friction that differs with direction, and a constant force beside it. A stiffening spring in
place of the former is not excluded, and with so much left what is missing may stand behind both.
The authors' reference model has the constant force, their improved one an asymmetric friction. What
is left is thousands of times the noise of the encoder; it depends on the way, and no driver's noise
is known: more is missing, or its form is another. So that one measure serves all, the authors'
parameters are put through the measure used here, and all models through the authors' relative force
error. That is the error of an inverse model on positions filtered and decimated as by their script
(`benchmarks/emps_force.py`), which gives back what they state of their parameters (4.08 % on run 1,
5.98 % on run 2). Their other measures are of a simulated closed loop (on run 2 8.94 % in the force,
0.0080 % in the position) and are not computed here.""",
    "bam_xl330": """\
**Servo with plastic gears (BAM, XL330).** Declared: motor, pendulum, Coulomb and viscous friction.
Named: friction that grows with the torque that is passed on. It is one of the terms that the
authors add to Coulomb and viscous friction; here it goes by the torque between the gear's teeth,
with the rotor before them. That form was added when the plain one had left 41 times the floor on
the selecting runs; the held-out ones chose nothing. The form without the rotor does as well (the
two are forms of one effect). The speed that the servo reports is 20 ms behind its own positions,
which is remarked when the record is read. Since the map moves it by that (`clock_shift`), the free
run is off by 0.060 rad (0.083 before). Some 50 times the floor are left, so a limit of the driver,
which explains much of what the named effect does there, is told as not excluded. The weight is
refitted to nearly the end of what is tried (-16.4 %, declared to 5 %), and the report says so. The
free run is never set anew from the record. The authors' published parameter sets leave 0.12 to 0.14
rad on the same runs, which is no like for like: they were identified on other logs, do not transfer
to these (at the highest gain some diverge) and run with the servo's loop in them; here the recorded
duty and supply drive the motor, and the model is refitted on logs of the same bench at other gains.
Declared and refitted are the like for like. The name depends on the motor's resistance being taken
as published: when it was given a tolerance of 20 % too, an earlier program (without that form)
found the same best candidate, but the verdict was "unknown, depends on time".""",
    "pneu_seal": """\
**Pneumatic seal.** A tester moves the rod, so position and pressure are inputs and the force is
predicted. Declared: friction = constant + share of pressure + viscous, on a piston of 25.0 mm. The
verdict is "none of the known effects": at 3 bar the force lies above what 1 and 5 bar foretell, in
both directions, a shift from run to run that nothing in these data explains. The candidate that
looks best on 3 bar makes the held-out 7 bar worse, and is not believed. On one of the two runs that
fit, what is left is largest just after a reversal. Rows around the turns, which positions read
every 10 ms do not resolve, are not compared. There is only one speed for each direction, so viscous
friction and asymmetry cannot be seen. The author publishes no model.""",
    "pneu_seal_repeats": """\
**Pneumatic seal, repeated.** Another O-ring, in a bore of 25.7 mm, run five times at 1, 3, 5 and 7
bar. The model is that of the first seal but for the bore. The first set of four runs fits; one set
after the cylinder was reconnected and one rerun select; the other two sets are held out. That split
was written before any of it was run, and nothing was changed since. The verdict is "none of the
known effects". The refitted model leaves 0.93 N on the runs that fit and the error above on those
held out. In each of these, as in all that select, the force lies above the model on average: what
this seal takes differs from set to set by more than is left within the first. A value of its own in
each run, of any one declared parameter, takes away 63 % of that at most (of the piston area).""",
    "dfki_pendulum": """\
**Pendulum on a geared drive.** Declared by masses and lengths; the torque is as the drive reports
it from its current, good to 20 %. No dependence repeats on the runs that select; the error stays at
3.7 times the noise of the speed there. The candidates that take a little of it away there raise it
on the runs held out. So it cannot be told whether something is missing: slow noise of the torque
would look so too (earlier programs said "unknown"). The torque's noise is known only by its steps
from row to row, and no run was driven the same way twice. A friction, an inertia, or a weight of
its own in each run explains none of it. In runs 3 and 4 (both driven by the same controller) what
is left swings at 29 Hz, at which the motion does not repeat itself: the rod, its mount or the loop.
The run that selects does not show it, so no elastic part is named. Run 4 carried another mass (1
kg), which the model is not told.""",
    "dfki_double_pendulum": """\
**Double pendulum.** Both joints are driven, with torques as reported. Masses and lengths are as the
authors identified them; friction lies between their two models, which differ tenfold in it.
"Published" is model_1.0. The data point to friction that goes by the angle, of a size of
its own in each joint, which takes 18 and 17 % of the held-out errors of the two joints away, and do
not exclude a quadratic drag, or weights off the axes. Three times the noise is left, and the torque
constant of the shoulder differs from run to run (0.73 to 1.27 of its median). Little separates
these names: earlier programs said Stribeck friction (20 and 24 %). Before a fix of 28 November the
verdict was "unknown": the refit was held by tolerances that weighed too much, and its held-out
errors were lower (0.435 and 0.866 rad/s). Half a second of a fast double pendulum is a hard
prediction; the remaining error is large, and so are the fitted changes of declared friction.""",
}
ROBOT = """## The robot (synthetic data)

Positions, tip force and commands only; the practice files say what they hide, the sealed ones do
not. The sealed files were diagnosed over forty times, each time with settings that were fixed
before ([where what was seen led to a change](how-unseen-the-data-are.md)): at first six of twelve
forms were incomplete. The results here are from later runs, with candidates and weights that were
made on recordings of an own generator (`python benchmarks/own_robot.py`); they are made by
`python benchmarks/diagnose_recordings.py robot/practice`, `robot/sealed`. Errors are in noise
deviations on runs 5 and 6.
"""
THESIS = """## The thesis's own measurements

`simpter reproduce measured --out DIR` takes what chapter 4 prints. The 246 points of slip torque
are lost. But a least-squares residual is orthogonal to every quadratic, so models that are
quadratic in the excitation can be fitted and judged exactly from Tables 3 and 4.

- **Slip torque against speed:** (39) leaves 9.68 lb-in (refitted 9.32) where the six quadratics
  leave 4.93. A logarithm of speed in place of the straight line leaves 6.14, and on a speed that
  had no part in the fit 8.17 against 12.85. Its form is incomplete: the term linear in the
  excitation grows with speed as no factor does.
- **Steps:** the declared lag and delay miss the seven printed numbers by 46 ms, refitted by 13 ms.
  What is left depends on the size of the step. A coil whose supply saturates, with 12 ms of dead
  time, leaves 1.6 ms (2.5 ms on a step left out). Of the 12 ms the data acquisition may account for
  4, which the thesis measured with its output wired to its input ("approximately one-third"). A
  slew limit does nearly as well; a step from 5 to 8 V would tell.
- **Breakaway** (41 runs from 0 V on, a level in the 32 of them from 2.25 V on) exceeds slip torque
  by a part that goes with v, not with v^2.

For anything else too few data are in print: no points, no scatter of (43), one direction, no
temperature, no order of tests.

![printed measurements](measured.png)
"""


def table(file: str) -> list[dict[str, str]]:
    """Rows of a benchmark's table."""
    with (ROOT / "benchmarks" / file).open(encoding="utf-8", newline="") as handle:
        return list(csv.DictReader(handle))


def lines() -> Iterator[str]:
    """The page."""
    yield LEAD
    rows = table("real_recordings.csv")
    yield "| rig, measure | declared | refitted | after | best candidate | published | verdict |"
    yield "|---|---|---|---|---|---|---|"
    for row in rows:
        seen = {stage: row[stage] or "-" for stage in STAGES}
        best = f"{seen['with it']} ({row['best candidate']})" if row["best candidate"] else "-"
        verdict = f"{row['verdict']}: {row['named']}" if row["named"] else row["verdict"]
        verdict += f" (or {row['not excluded']})" if row["named"] and row["not excluded"] else ""
        stated = f"; authors: {row['authors state']}" if row["authors state"] else ""
        yield (
            f"| {row['rig']}: {row['measure']} | {seen['declared']} | {seen['refitted']} | "
            f"{seen['after']} | {best} | {seen['published model']}{stated} | {verdict} |"
        )
    yield ""
    for rig in dict.fromkeys(row["rig"] for row in rows):
        yield PARAGRAPHS[rig] + "\n"
    yield "![held out](real-data-bam.png)\n"
    command = "simpter diagnose $SIMPTER_DATA/bam_xl330/data.csv --model bam_xl330"
    yield f"`held_out.png` of `{command}`.\n"
    yield ROBOT
    yield "| file | verdict | named | not excluded | refitted | after | floor |"
    yield "|---|---|---|---|---|---|---|"
    for file in ("practice", "sealed"):
        for row in table(f"verdicts_robot_{file}.csv"):
            yield (
                f"| {row['file']} | {row['verdict']} | {row['effects'] or '-'} | "
                f"{row['cannot_exclude'] or '-'} | {row['refitted']} | {row['after']} | "
                f"{row['floor']} |"
            )
    yield ""
    yield THESIS.rstrip()


def main() -> int:
    """Write or check the page."""
    text = "\n".join(lines()) + "\n"
    if "--check" in sys.argv:
        return 0 if PAGE.read_text(encoding="utf-8") == text else 1
    PAGE.write_text(text, encoding="utf-8")
    (PAGE.parent / "measured.png").write_bytes(pictures(["measured"], simulate)["measured"][1])
    return 0


if __name__ == "__main__":
    sys.exit(main())
