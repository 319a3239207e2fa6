"""Figures 45-47 and the three causes that 5.4.2 names for the smoother ride with feedback."""

from __future__ import annotations

import numpy as np

from ..known_units import INCH
from ..laws import LBF_IN
from ..measuring.metrics import measures
from ..measuring.sampling import Samples, sample
from ..rigs.inputs import drawn, nominal
from ..rigs.line import line
from ..trajectory import Trajectory
from .rows import Engine, Row, claim
from .standard import plausible, reached, run, standard, table


def clutch_two(engine: Engine, name: str) -> tuple[Samples, np.ndarray, np.ndarray]:
    """Samples at 5 ms, actual and desired torque of clutch 2 [lb-in] (Figures 46, 47)."""
    trajectory = standard(engine, name)
    found = sample(trajectory, np.arange(int(trajectory.t_end / 0.005)) * 0.005)
    actual = np.abs(found.tau[:, 1]) / LBF_IN
    return found, actual, found.held["desired_2"] / LBF_IN


def feedback(engine: Engine, draws: int = 64) -> list[Row]:
    """Figures 45-47, then the causes."""
    return [*figures(engine, draws), *causes(engine), robustness(engine, draws)]


def figures(engine: Engine, draws: int) -> list[Row]:
    """Paths and clutch 2 torques."""
    nominal_runs = table(engine)
    base, with_p = clutch_two(engine, "baseline"), clutch_two(engine, "P")
    rms = [float(np.sqrt(np.mean((actual - wanted) ** 2))) for _, actual, wanted in (base, with_p)]
    peak = [float(max(actual.max(), wanted.max())) for _, actual, wanted in (base, with_p)]
    mean = [float(wanted.mean()) for _, _, wanted in (base, with_p)]
    every = [r for r in plausible(engine, draws) if r["baseline"].finished and r["P"].finished]
    nearer = np.mean([r["P"].average_error < r["baseline"].average_error for r in every])
    share = float(np.mean([r["P"].max_error < r["baseline"].max_error < 4.0 for r in every]))
    low, high = (
        nominal_runs["baseline"].max_error / INCH,
        nominal_runs["P"].max_error / INCH,
    )
    return [
        claim(
            "A47",
            "Figure 45: feedback keeps the tip nearer to the path, all within y = 20 to 28 in",
            "apparent",
            f"largest error {low:.2f} in without and {high:.2f} in with; nearer on average for "
            f"{100 * nearer:.0f} % of {len(every)} plausible inputs",
            high < low < 4.0,
            share=share,
        ),
        claim(
            "A39 S55",
            "Figures 46, 47: actual torque of clutch 2 follows the desired one better with "
            "feedback",
            "better",
            f"rms difference {rms[0]:.0f} and {rms[1]:.0f} lb-in",
            rms[1] < rms[0],
            baseline=rms[0],
            feedback=rms[1],
        ),
        claim(
            "A39",
            "torques of clutch 2 are much lower with feedback",
            "0-600 lb-in without",
            f"largest {peak[0]:.0f} and {peak[1]:.0f} lb-in, mean demand {mean[0]:.0f} and "
            f"{mean[1]:.0f} lb-in",
            mean[1] < mean[0],
            mean_baseline=mean[0],
            mean_feedback=mean[1],
        ),
    ]


def switched_on_alone(engine: Engine) -> dict[str, Trajectory]:
    """Runs with one cause each, by name."""
    prompt = nominal().replace(time_constant=0.005, delay=0.0)
    return {
        "table alone": run(engine),
        "feedback 0.16": run(engine, gain=0.16),
        "matched table": run(engine, matched=True),
        "matched table, clutch in 5 ms": engine(line(inputs=prompt, matched=True)),
        "table alone, half the stiffness": engine(
            line(inputs=nominal().replace(stiffness=nominal().stiffness / 2.0))
        ),
    }


def causes(engine: Engine) -> list[Row]:
    """S58: better tracking, smaller demand, fewer transitions; each switched on alone.

    A matched table with a prompt clutch tracks without feedback; feedback on a prompt clutch and a
    matched table has nothing to do. What is left of the jerk says what each cause carries.
    """
    found = {name: measures(trajectory) for name, trajectory in switched_on_alone(engine).items()}
    words = "; ".join(
        f"{name}: error {m.average_error / INCH:.3f} in, variation "
        f"{m.variation_smooth / INCH:.0f} + {m.variation_jumps / INCH:.0f} in/s^3, "
        f"{m.transitions} transitions"
        for name, m in found.items()
    )
    total = {n: (m.variation_smooth + m.variation_jumps) / INCH for n, m in found.items()}
    base, p, matched = (total[k] for k in ("table alone", "feedback 0.16", "matched table"))
    soft = found["table alone, half the stiffness"]
    return [
        claim(
            "S58",
            "first cause: better torque following alone (a table that matches the clutch) does it",
            "tracking improves",
            words,
            matched < 0.5 * (base + p),
            why="variation of acceleration is the jerk without the sampling step",
            **{k.replace(" ", "_"): v for k, v in total.items()},
        ),
        claim(
            "S58",
            "second cause: a smaller demand lowers the jerk (half the virtual stiffness)",
            "smaller demand",
            f"variation {total['table alone, half the stiffness']:.0f} against {base:.0f} in/s^3, "
            "at "
            f"an error of {soft.average_error / INCH:.3f} in",
            total["table alone, half the stiffness"] < base,
        ),
        claim(
            "S58",
            "third cause: fewer transitions carry the difference",
            "3 against 6 transitions",
            f"the jumps at transitions make up "
            f"{100 * found['table alone'].variation_jumps / INCH / base:.0f} % of the variation "
            f"without and {100 * found['feedback 0.16'].variation_jumps / INCH / p:.0f} % with "
            "feedback; the smooth part falls as well",
            (found["table alone"].variation_jumps - found["feedback 0.16"].variation_jumps)
            > 0.5 * (base - p) * INCH,
        ),
    ]


def robustness(engine: Engine, draws: int) -> Row:
    """S59: error against the table's error, with and without feedback."""
    scales = (0.6, 0.8, 1.0, 1.25, 1.6)
    spread = {}
    for gain in (0.0, 0.16):
        errors = []
        for scale in scales:
            inputs = nominal().replace(table_torque=nominal().table_torque * scale)
            errors.append(reached(line(gain=gain, inputs=inputs), engine, inputs.line_y))
        spread[gain] = [e.average_error for e in errors]
    ratio = {g: max(v) / min(v) for g, v in spread.items()}
    shares = []
    for inputs in drawn(min(draws, 16), seed=59):
        pair = []
        for gain in (0.0, 0.16):
            ends = [
                reached(
                    line(gain=gain, inputs=inputs.replace(table_torque=inputs.table_torque * s)),
                    engine,
                    inputs.line_y,
                ).average_error
                for s in (0.7, 1.4)
            ]
            pair.append(abs(ends[1] - ends[0]))
        shares.append(pair[1] < pair[0])
    text = ", ".join(
        f"{s:g}: {a:.3f}/{b:.3f}" for s, a, b in zip(scales, spread[0.0], spread[0.16], strict=True)
    )
    return claim(
        "S59",
        "with feedback the run depends less on errors of the table",
        "more robust",
        f"average error [in] without/with for tables scaled by {text}; "
        f"holds for {100 * np.mean(shares):.0f} % of {len(shares)} plausible inputs",
        ratio[0.16] < ratio[0.0],
        share=float(np.mean(shares)),
        without=ratio[0.0],
        with_feedback=ratio[0.16],
    )
