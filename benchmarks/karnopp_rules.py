"""Which of the thesis's rules keeps a run from the exact one: one rule exchanged after another.

    python benchmarks/karnopp_rules.py [--band 1e-7] [--out FILE.csv]

The scenarios of the thesis's tables with a narrow band and tight tolerances, as described there;
then with the limiter of ``fair`` rules, with all of them, with the general rule in place of the
tables, and with the limiter that resets speeds (``tuned``).  The largest distance from the exact
run on the way in units of the distance travelled.  ``karnopp_rules.csv`` beside this file was made
with

    python benchmarks/karnopp_rules.py --out benchmarks/karnopp_rules.csv
"""

from __future__ import annotations

import argparse
from dataclasses import replace
from functools import partial

from karnopp_scenarios import travel
from tables import write

from simpter_hybrid.comparison.candidates import LONGEST, Candidate
from simpter_hybrid.comparison.compare import compare
from simpter_hybrid.engine import simulate as exactly
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.karnopp import FAIR, THESIS, TUNED, simulate

SCENARIOS = ("circle-ideal", "line-y24", "line-y24-30hz", "line-y24-p016", "line-y24-velocity",
             "line-y24-velocity-gradual", "standard-input")  # fmt: skip
RULES = {
    "thesis, tight tolerance": THESIS,
    "its limiter exchanged": replace(THESIS, limiter=FAIR.limiter),
    "fair": FAIR,
    "general rule": replace(FAIR, cases="general"),
    "tuned": TUNED,
}
#: More steps than this, and a run chatters.
STEPS = 100_000


def rows_of(name: str, band: float) -> list[dict]:
    """All sets of rules on one scenario."""
    scenario = load(name)
    exact = exactly(scenario)
    rtol = max(1e-3 * band, 1e-11)
    more = {"rtol": rtol, "atol": 1e-3 * rtol, "max_step": LONGEST, "max_steps": STEPS}
    chosen = [
        Candidate(word, word, band, partial(simulate, band=band, rules=r, compiled=True, **more))
        for word, r in RULES.items()
    ]
    rows = compare(scenario, chosen, exact).rows
    way = travel(exact)
    return [
        {"scenario": name, "band": f"{band:g}", "rules": row.name, "missed": row.missed,
         "way": "chatters" if row.status == "failed" else f"{row.path_error / way:.1e}"}
        for row in rows
    ]  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--band", type=float, default=1e-7)
    parser.add_argument("--out", help="CSV file")
    args = parser.parse_args()
    rows = [row for name in SCENARIOS for row in rows_of(name, args.band)]
    write(rows, args.out)


if __name__ == "__main__":
    main()
