"""Figures 43 and 44 of the thesis with everything uncertain that it does not print: 10,000 runs.

    python benchmarks/gain_sweep.py [--gains 50] [--draws 200] [--jobs 1] [--picture FILE.png]

Average error and average jerk of the standard line run over the torque feedback gain, at the
nominal inputs and for draws of those the thesis does not print, over their plausible ranges
(``devices/pter_parameters.toml``). Measures are the thesis's (44) and (46) on a grid of 5 ms, as in
``simpter_hybrid/reproduce/gain_sweep.py``, which judges its claims with 31 runs. One draw is one
call of the compiled engine: a scenario and all gains.
"""

from __future__ import annotations

import argparse
import resource
import sys
import time
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np

from simpter_hybrid.ensemble import Rows, ensemble
from simpter_hybrid.kernel.records import STOPPED
from simpter_hybrid.known_units import INCH
from simpter_hybrid.laws import LBF_IN
from simpter_hybrid.loads.operator import Operator
from simpter_hybrid.measuring.metrics import (
    differences,
    path_weighted_average,
    time_weighted_average,
)
from simpter_hybrid.rigs.inputs import Inputs, drawn, nominal
from simpter_hybrid.rigs.line import line
from simpter_hybrid.scenario import Scenario
from simpter_hybrid.sweeps.brief import after
from simpter_hybrid.sweeps.tip_motion import tip_motion

#: Step of the measures [s]; sinusoids that an operator may have.
STEP, LINES = 0.005, 4
#: Measures by name, and the thesis's numbers at gains 0 and 0.2 for them.
MEASURES = {
    "error": ("average error / in", (0.36, 0.13)),
    "jerk": ("average jerk / (in/s³)", (456.0, 317.0)),
    "saturated": ("share of time at full scale", None),
}


def scenario(inputs: Inputs) -> Scenario:
    """The run with torque feedback; sinusoids of no size make up the number, so that one model
    serves all draws."""
    run = line(gain=0.1, inputs=inputs)
    operator = run.loads[0]
    assert isinstance(operator, Operator)
    more = ((0.0, 1.0, 0.0),) * (LINES - len(operator.lines))
    return run.replace(loads=(Operator(operator.along, operator.angle, operator.lines + more),))


def one_draw(inputs: Inputs, gains: np.ndarray) -> dict[str, np.ndarray]:
    """Measures of a draw at all gains, (gains,) each; NaN where a run did not reach the end."""
    run = scenario(inputs)
    grid = np.arange(round(run.t_end / STEP) + 1) * STEP

    def measure(rows: Rows, end: np.ndarray, t_end: np.ndarray) -> dict[str, np.ndarray]:
        count = (t_end / STEP + 1e-9).astype(int) + 1
        cases = [
            _measured(run, grid[:k], rows, case, inputs.line_y) for case, k in enumerate(count)
        ]
        return {
            name: np.array(column)
            for name, column in zip(MEASURES, zip(*cases, strict=True), strict=True)
        }

    vary = {"controller.3.gain": gains / LBF_IN}
    found = ensemble(run, vary, grid=after(grid, run.t_end), measure=measure, together=True)
    reached = found.status == STOPPED
    return {
        **{name: np.where(reached, found.measures[name], np.nan) for name in MEASURES},
        "events": found.event_counts().astype(float),
        "seconds": found.t,
    }


def _measured(
    run: Scenario, t: np.ndarray, rows: Rows, case: int, line_y: float
) -> tuple[float, ...]:
    k = len(t)
    tip, acceleration = tip_motion(run, rows.q[case, :k], rows.qd[case, :k], rows.qdd[case, :k])
    whole = np.isfinite(acceleration).all(axis=1)
    t, tip, acceleration = t[whole], tip[whole], acceleration[whole]
    error, _ = path_weighted_average(tip, np.abs(tip[:, 1] - line_y))
    jerk = time_weighted_average(t, differences(t, acceleration))
    full = np.array([clutch.full_scale for clutch in run.clutches])
    share = (rows.held[case, :k][whole, : len(full)] >= full).mean(axis=0).max()
    return error / INCH, jerk / INCH, float(share)


def swept(gains: np.ndarray, draws: list[Inputs], jobs: int) -> dict[str, np.ndarray]:
    """Measures (draws, gains) by name."""
    if jobs == 1:
        found = [one_draw(inputs, gains) for inputs in draws]
    else:
        with ProcessPoolExecutor(jobs) as pool:
            found = list(pool.map(one_draw, draws, [gains] * len(draws), chunksize=4))
    return {name: np.stack([one[name] for one in found]) for name in found[0]}


def draw(path: Path, gains: np.ndarray, found: dict[str, np.ndarray]) -> None:
    """The picture: nominal inputs, median and middle 80 % of the draws."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    from simpter_hybrid.plots.style import BLUE, INK, ORANGE

    figure, axes = plt.subplots(1, 3, figsize=(12, 3.8), layout="constrained")
    for ax, (name, (label, printed)) in zip(axes, MEASURES.items(), strict=True):
        low, middle, high = np.nanquantile(found[name][1:], (0.1, 0.5, 0.9), axis=0)
        ax.fill_between(gains, low, high, color=BLUE, alpha=0.2, lw=0, label="middle 80 %")
        ax.plot(gains, middle, color=BLUE, label="median of the draws")
        ax.plot(gains, found[name][0], color=INK, lw=1, label="nominal inputs")
        if printed is not None:
            ax.plot((0.0, 0.2), printed, "o", color=ORANGE, label="thesis, read off at 0 and 0.2")
        ax.set(xlabel="torque feedback gain / (V/(lb-in))", ylabel=label, ylim=(0.0, None))
    axes[0].legend(fontsize=8)
    figure.savefig(path, dpi=110, metadata={"Software": None})


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--gains", type=int, default=50)
    parser.add_argument("--draws", type=int, default=200)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--picture", type=Path)
    args = parser.parse_args()
    gains = np.linspace(0.0, 0.6, args.gains)
    one_draw(nominal(), gains[:1])  # What is compiled stays on disk and is not counted.
    clock, cpu = time.perf_counter(), time.process_time()
    found = swept(gains, [nominal(), *drawn(args.draws, seed=43)], args.jobs)
    clock, cpu = time.perf_counter() - clock, time.process_time() - cpu
    cpu += resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    runs, ended = found["error"].size, int(np.isfinite(found["error"]).sum())
    print(
        f"{runs} runs, {found['seconds'].mean():.1f} s each on average, {ended} of them reached "
        f"the end; {found['events'].sum():.0f} events\n{cpu:.0f} CPU s, {clock:.0f} s by the "
        f"clock: {runs / cpu:.0f} runs a CPU second with their measures"
    )
    for name, (label, _) in MEASURES.items():
        table = found[name][1:]
        at = [int(np.argmin(np.abs(gains - g))) for g in (0.0, 0.1, 0.16, 0.2, 0.4, 0.6)]
        words = [f"{gains[k]:.2f}: {np.nanmedian(table[:, k]):.3g}" for k in at]
        print(f"median {label} at gain " + ", ".join(words))
    if args.picture:
        draw(args.picture, gains, found)
        print(f"wrote {args.picture.name}", file=sys.stderr)


if __name__ == "__main__":
    main()
