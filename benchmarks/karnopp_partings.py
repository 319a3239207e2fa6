"""Where Karnopp's runs part from the exact ones for good, and why: run by run.

    python benchmarks/karnopp_partings.py [--runs 100] [--bands 1e-6,1e-8] [--out FILE.csv]
        [--examples FILE.json] [--elsewhere FILE.json]
    python benchmarks/karnopp_partings.py --why "constant 23" --bands 1e-10

The random runs of ``karnopp_ensemble.py`` with the tuned rules; looked at are those that end more
than 1 % of their largest displacement away.  The parting is the first instant from which the modes
differ for more than 1 ms, or at which a command differs by more than 0.05 V.  Its cause is what
a test shows, the first of these that holds:

- ``step``: with steps of 0.5 ms at most and the same band it ends in the right place;
- ``sensitive``: the exact run itself, started as far away as the band, ends as far away;
- ``sample`` or ``narrower``: with a band of 1e-11 and such steps it ends in the right place;
  ``sample`` where a sample falls between the two runs' versions of the event, or less than 1 ms
  after them;
- ``ambiguous``: no band helps; where the run with that band parts, the exact run's event has other
  consistent successors (``--why`` lists them), and Karnopp's run took one of them;
- ``unexplained``.

``karnopp_partings.csv`` and ``.json`` beside this file were made by

    python benchmarks/karnopp_partings.py --out benchmarks/karnopp_partings.csv \\
        --examples benchmarks/karnopp_partings.json
"""

from __future__ import annotations

import argparse
import json
import sys
import warnings
from collections import Counter
from pathlib import Path

import numpy as np
from karnopp_ensemble import variable
from random_runs import KINDS, random_run
from tables import write

from simpter_hybrid.compiled import simulate as exact
from simpter_hybrid.explanation.explain import explain_event
from simpter_hybrid.karnopp import TUNED
from simpter_hybrid.karnopp.compiled import Compiled
from simpter_hybrid.karnopp.simulate import on_grid, simulate

RIGHT = 0.01
#: Modes that differ for longer are a parting [s]; commands that differ by more [V].
WINDOW, COMMAND = 1e-3, 0.05
FINE_STEP = 5e-4
NARROWEST = 1e-11
STEPS = 400_000
CAUSES = ("step", "sensitive", "sample", "narrower", "ambiguous", "unexplained")


def ending(run, reference) -> float:
    """Error of the final angles in units of the largest displacement."""
    reach = float(np.abs(reference.step_y[:, :2] - reference.step_y[0, :2]).max())
    if run.status == "failed":
        return float("inf")
    return float(np.abs(run.end - reference.end)[:2].max()) / max(reach, 1e-3)


def modes_part(a, b) -> float:
    """The first instant from which the modes of two runs differ for more than ``WINDOW`` [s]."""
    ends = min(a.t_end, b.t_end)
    times = np.unique(np.concatenate([a.segment_t[:, 0], b.segment_t[:, 0], [ends]]))
    middle = 0.5 * (times[1:] + times[:-1])
    rows = [r.mode[np.searchsorted(r.segment_t[:, 0], middle, side="right") - 1] for r in (a, b)]
    start = None
    for k, differ in enumerate((rows[0] != rows[1]).any(axis=1)):
        if not differ:
            start = None
            continue
        start = times[k] if start is None else start
        if times[k + 1] - start > WINDOW:
            return float(start)
    return np.inf


def commands_part(a, b) -> float:
    """The first sample at which a command differs by more than ``COMMAND`` [s]."""
    period, m = a.scenario.period, a.scenario.device.m
    if period <= 0.0:
        return np.inf
    for k in range(int(min(a.t_end, b.t_end) / period)):
        t = k * period
        apart = a.held[a.segment_at(t + 1e-9)][:m] - b.held[b.segment_at(t + 1e-9)][:m]
        if np.abs(apart).max() > COMMAND:
            return t
    return np.inf


def near(run, t: float) -> int:
    """Number of the event nearest to ``t`` [s]."""
    return int(np.argmin([abs(event.t - t) for event in run.events]))


def took_another(reference, run, t: float) -> bool:
    """Whether the exact event at the parting was ambiguous and the other run took another way."""
    k = near(reference, t)
    if abs(reference.events[k].t - t) > WINDOW:
        return False
    after = tuple(int(v) for v in run.mode[run.segment_at(min(t + WINDOW, run.t_end))])
    return any(tuple(c.mode) == after for c in explain_event(reference, k).others)


def close_to_a_sample(reference, run, t: float) -> bool:
    """Whether a sample falls between the two runs' changes, or just after them."""
    period = reference.scenario.period
    if period <= 0.0:
        return False
    instants = [r.events[near(r, t)].t for r in (reference, run)]
    early, late = min(*instants, t), max(*instants, t)
    return np.ceil(early / period - 1e-9) * period <= late + WINDOW


def recorded(scenario, settings):
    """A run with its record."""
    return simulate(
        scenario, settings.band, rules=TUNED, rtol=settings.rtol, atol=settings.atol,
        max_step=settings.max_step, max_steps=settings.max_steps, compiled=True,
    )  # fmt: skip


def cause_of(scenario, reference, run, band: float, t: float) -> str:
    """Which of ``CAUSES`` made a run part at ``t`` [s]."""
    ready = Compiled(scenario)

    def lands(settings) -> bool:
        return ending(on_grid(ready, [], settings), reference) <= RIGHT

    if lands(variable(TUNED, band, max_step=FINE_STEP, max_steps=STEPS)):
        return "step"
    for way in (-1.0, 1.0):
        moved = scenario.replace(q=(scenario.q[0] + way * band, scenario.q[1] + band))
        if ending(exact(moved), reference) > RIGHT:
            return "sensitive"
    narrow = variable(TUNED, NARROWEST, max_step=FINE_STEP, max_steps=STEPS)
    if lands(narrow):
        return "sample" if close_to_a_sample(reference, run, t) else "narrower"
    other = recorded(scenario, narrow)
    if took_another(reference, other, parts(reference, other)[0]):
        return "ambiguous"
    return "unexplained"


def parts(a, b) -> tuple[float, str]:
    """When two runs part [s], and in what."""
    modes, commands = modes_part(a, b), commands_part(a, b)
    return min(modes, commands), "modes" if modes <= commands else "commands"


def parting(kind: str, seed: int, band: float) -> dict | None:
    """The parting of one run, or None where it ends in the right place."""
    scenario = random_run(kind, seed)
    reference = exact(scenario)
    settings = variable(TUNED, band, max_steps=STEPS)
    error = ending(on_grid(Compiled(scenario), [], settings), reference)
    if error <= RIGHT:
        return None
    run = recorded(scenario, settings)
    t, first = parts(reference, run)
    found = {"kind": kind, "seed": seed, "band": band, "error": float(f"{error:.2g}")}
    if t == np.inf:
        return found | {"t": None, "first": "nothing", "cause": "narrower"}
    event = reference.events[near(reference, t)]
    return found | {
        "t": float(f"{t:.9g}"), "first": first,
        "cause": cause_of(scenario, reference, run, band, t),
        "exact_event_t": float(f"{event.t:.9g}"), "exact_before": list(event.before),
        "exact_after": list(event.after),
        "other_before": run.mode[run.segment_at(max(t - 1e-9, 0.0))].tolist(),
        "other_after": run.mode[run.segment_at(min(t + WINDOW, run.t_end))].tolist(),
    }  # fmt: skip


def why(name: str, band: float) -> None:
    """Print what the exact run decided where a run parts, and what else was consistent."""
    kind, _, seed = name.rpartition(" ")
    scenario = random_run(kind, int(seed))
    reference = exact(scenario)
    t, first = parts(reference, recorded(scenario, variable(TUNED, band, max_steps=STEPS)))
    print(f"{name}, band {band:g}: {first} part at t = {t:.9g} s")
    if t < np.inf:
        print(explain_event(reference, near(reference, t)))


def counted(found: list[dict], bands: list[float], runs: int) -> list[dict]:
    """A line a band."""
    lines = []
    for band in bands:
        own = Counter(f["cause"] for f in found if f["band"] == band)
        line = {"band": f"{band:g}", "runs": runs, "parted": own.total()}
        lines.append(line | {cause: own[cause] for cause in CAUSES})
    return lines


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--runs", type=int, default=100, help="of each kind")
    parser.add_argument("--bands", default="1e-6,1e-8")
    parser.add_argument("--out", help="CSV file for the counts")
    parser.add_argument("--examples", help="JSON file for every run that parts")
    parser.add_argument("--elsewhere", help="only these runs (karnopp_ensemble.py --elsewhere)")
    parser.add_argument("--why", metavar="RUN", help="explain the event at which one run parts")
    args = parser.parse_args()
    warnings.filterwarnings("ignore", message="Cannot cache compiled function")
    bands = [float(word) for word in args.bands.split(",")]
    if args.why:
        why(args.why, bands[0])
        return
    cases = [(kind, seed, b) for b in bands for seed in range(args.runs) for kind in KINDS]
    if args.elsewhere:
        listed = json.loads(Path(args.elsewhere).read_text(encoding="utf-8"))
        cases = [case for case in cases if list(case) in listed]
    found = []
    for band in bands:
        found += filter(None, (parting(*case) for case in cases if case[2] == band))
        print(counted(found, [band], args.runs * len(KINDS))[0], file=sys.stderr, flush=True)
    lines = counted(found, bands, args.runs * len(KINDS))
    if args.examples:
        text = "".join(f"{json.dumps(f)},\n" for f in found).removesuffix(",\n")
        Path(args.examples).write_text(f"[\n{text}\n]\n", encoding="utf-8")
    write(lines, args.out)


if __name__ == "__main__":
    main()
