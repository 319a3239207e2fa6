"""How often Case 7's previous-step rule lets the wrong clutches go, by how fast the load grows.

    python benchmarks/lumped_actuator.py [--draws 300] > benchmarks/lumped_actuator.csv

Single instants of PTER at rest with random inertia, breakaway torques and directions of the load,
against enumeration of all modes (``tests/lumped_choices.py``). ``growth``: how far, in units of
what the clutches can hold, the load at most moves from below to above it within one step; "from
nothing": there was no load in the step before. ``not held``: the rule let go before it had to.
"""

from __future__ import annotations

import argparse
import csv
import itertools
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests"))

from lumped_choices import GROWTH, share_wrong

from simpter_hybrid.karnopp import FAIR, THESIS, TUNED, Rules

RULES = {
    "thesis": THESIS,
    "thesis, signs of (24)-(29) only": Rules(signs="printed"),
    "fair": FAIR,
    "tuned": TUNED,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--draws", type=int, default=300, help="for each stuck set")
    draws = parser.parse_args().draws
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(["rules", "stuck clutches", "growth", "wrong", "right", "not held"])
    for (name, rules), size, growth in itertools.product(RULES.items(), (3, 4), GROWTH):
        total = [0, 0, 0]
        for stuck in itertools.combinations(range(4), size):
            found = share_wrong(rules, stuck, growth, draws * (1 if size == 3 else 4))
            total = [a + b for a, b in zip(total, found, strict=True)]
        word = "from nothing" if growth is None else f"{growth:g}"
        writer.writerow([name, size, word, *total])
        sys.stdout.flush()


if __name__ == "__main__":
    main()
