"""A rig of one coordinate that nobody wrote code for: diagnose what our own generator hides.

    python benchmarks/own_axis.py               # goes on where it was; own_axis.csv, own_axis.md
    python benchmarks/own_axis.py --seeds 5
    python benchmarks/own_axis.py --fresh       # rows of other programs are made anew

Model and map are those of docs/diagnose.md.  Files are made, diagnosed and thrown away.
"""

from __future__ import annotations

import argparse
from functools import partial
from pathlib import Path

from own_axis_files import KINDS, OF_DRIVER, OF_FORCE, OF_TOLD, SENSOR, SENSORS, write
from own_one_axis import Rows, by_kind, counted, errors_left, gone_through, row_of, score
from program import commit

HERE = Path(__file__).parent
TABLE, PAGE = HERE / "own_axis.csv", HERE / "own_axis.md"


def logs(sensor: str, kind: str) -> bool:
    """Whether there is such a recording: what was told has no sensor that errs, else no driver."""
    hidden = {*KINDS[kind][0]}
    if sensor not in ("set points", "told"):
        return not hidden & {*OF_DRIVER}
    of_driver = sensor == "set points" or hidden & {*OF_DRIVER} or kind in OF_TOLD
    return bool(of_driver) and not hidden & {*OF_FORCE}


def page(rows: Rows) -> str:
    """own_axis.md."""
    lines = [ABOUT, *counted(rows, SENSORS), "", errors_left(rows), ""]
    return "\n".join([*lines, *by_kind(rows, KINDS, SENSORS, logs)]) + "\n"


ABOUT = """# A slide that nobody wrote code for (synthetic)

    python benchmarks/own_axis.py

Verdicts on recordings of `own_axis_files.py`, by the model and the map of docs/diagnose.md; in
brackets the error after over the floor on the runs that select. `by-rest` (more friction for a
centimetre after every reversal) is in nobody's list: right is "unknown". Friction that differs with
direction and a constant force are the same where all friction is Coulomb's; a force sensor that
shows too much, and more mass with less friction, are the same wherever nothing else is known of
either: a set is all that can be said. Three have a noisier sensor of force: six times the noise
(2 % of the friction), or slow noise (10 ms, 1 %), of which "lack or noise" is as far as one can go
unless every push is given twice (`repeated`). Friction of another level in each trial (3 %) is
"unknown" as well, and depends on the run; beside it effects should be found all the same. "moved"
takes the positions as what moved the slide and the force as what that took: noise of the positions
is noise of the inertial force there, several times that of the force's sensor, and rows at rest and
at turns are not compared, so less can be seen. "set points" are those of a servo, whose loop the
model runs itself: no force is known. "told": what a driver was told, as exactly as it was told.
"""


def main() -> None:
    """Go through what is not yet there."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--kinds", nargs="*", default=list(KINDS))
    parser.add_argument("--sensors", nargs="*", default=list(SENSORS))
    parser.add_argument("--fresh", action="store_true", help="make rows of other programs anew")
    args, program = parser.parse_args(), commit()
    cases = (
        (kind, sensor, seed)
        for seed in range(1, args.seeds + 1)
        for kind in args.kinds
        for sensor in args.sensors
        if logs(sensor, kind)
    )
    made, scored = partial(row_of, write, program), partial(score, kinds=KINDS, sensor=SENSOR)
    rows = gone_through(TABLE, cases, made, scored, program if args.fresh else "")
    PAGE.write_text(page(rows), encoding="utf-8")


if __name__ == "__main__":
    main()
