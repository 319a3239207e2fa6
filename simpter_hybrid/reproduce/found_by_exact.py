"""What the band hides or invents: scatter over the gain and the number of transitions."""

from __future__ import annotations

import numpy as np

from ..known_units import INCH
from ..rigs.inputs import drawn, nominal
from ..rigs.line import line
from .found_causes import BANDS, banded, causes, counted, exactly, over_inputs
from .gain_sweep import GAINS, point, scatter, swept
from .rows import Engine, Row, claim
from .standard import brief

#: Rules and bands of the sweeps over the gain.
SWEPT = tuple((rules, band) for rules in ("thesis", "fair") for band in (1e-3, 1e-4))
#: Gains at which transitions are counted, and what the thesis counts.
PRINTED = ((0.0, 6), (0.16, 3))
#: Rules and tolerances with which they are counted; the first is SIMULINK's default.
COUNTED = tuple((rules, rtol) for rules in ("thesis", "fair") for rtol in (1e-3, 1e-6))


def sweeps(engine: Engine) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Error [in] and jerk [in/s^3] over the gains, exact and with bands."""
    found = {"exact": columns(swept(engine))}
    for rules, band in SWEPT:
        name = f"Karnopp ({rules} rules), {band:g} rad/s"
        found[name] = columns(swept(banded(rules, band), False))
    return found


def columns(points) -> tuple[np.ndarray, np.ndarray]:
    """Error and jerk of a sweep."""
    return (
        np.array([p.brief.average_error for p in points]),
        np.array([p.brief.average_jerk for p in points]),
    )


def found_by_exact(engine: Engine, draws: int = 8) -> list[Row]:
    """The two questions, and whether the exact run itself is trustworthy."""
    return [
        *scatters(engine, draws), *causes(engine), *transition_counts(engine, draws),
        *trust(engine),
    ]  # fmt: skip


def scatters(engine: Engine, draws: int) -> list[Row]:
    """Is the scatter above gain 0.2 the robot's or the simulator's?"""
    gains = np.array(GAINS)
    high = gains >= 0.2
    found = sweeps(engine)
    jerk = {n: scatter(j[high]) for n, (_, j) in found.items()}
    error = {n: scatter(e[high]) for n, (e, _) in found.items()}
    text = "; ".join(f"{n}: error {error[n]:.3f}, jerk {jerk[n]:.3f}" for n in found)
    others = [v for n, v in jerk.items() if n != "exact"]
    rough = []
    for inputs in drawn(draws, seed=44):
        points = [point(engine, g, inputs, False) for g in GAINS[::2]]
        e, j = columns(points)
        top = gains[::2] >= 0.2
        low = gains[::2] <= 0.2
        rough.append(
            scatter(j[top]) > 1.5 * scatter(j[low]) and scatter(e[top]) > 1.5 * scatter(e[low])
        )
    return [
        claim(
            "A38",
            "the scatter above gain 0.2 is the robot's",
            "ascribed to saturation",
            text,
            jerk["exact"] > 0.5 * float(np.median(others)),
            why="scatter: rms second difference over mean, gains 0.2 to 0.6 in steps of 0.02; the "
            "same scenario, the same measures, only the friction model differs",
            **{n: v for n, v in jerk.items()},
        ),
        claim(
            "A38",
            "the exact model scatters more above 0.2 than below for other plausible inputs",
            "erratic",
            f"{100 * np.mean(rough):.0f} % of {len(rough)} plausible inputs",
            float(np.mean(rough)) > 0.5,
            share=float(np.mean(rough)),
        ),
    ]


def transition_counts(engine: Engine, draws: int) -> list[Row]:
    """How many transitions each simulator counts in the same two runs."""
    rows = []
    for gain, printed in PRINTED:
        exact = exactly(engine, gain)
        counts = {
            (rules, band, rtol): counted(rules, band, rtol, gain)
            for rules, rtol in COUNTED
            for band in BANDS
        }
        text = "; ".join(
            f"{rules} rules, {band:g} rad/s, rtol {rtol:g}: {b.transitions} in {b.run_time:.2f} s, "
            f"error {b.average_error:.3f} in"
            for (rules, band, rtol), b in counts.items()
        )
        numbers = [b.transitions for b in counts.values()]
        rows.append(
            claim(
                "A35 A36 S54",
                f"the number of transitions is the robot's (gain {gain:g})",
                str(printed),
                f"exact: {exact.transitions} in {exact.run_time:.2f} s, error "
                f"{exact.average_error:.3f} in; {text}",
                max(numbers) - min(numbers) <= 1 and abs(numbers[0] - exact.transitions) <= 1,
                why="band, tolerance and the rules that the thesis leaves open each change the "
                "count",
                exact=exact.transitions,
                least=min(numbers),
                most=max(numbers),
            )
        )
    return [*rows, of_the_inputs(engine, draws)]


def of_the_inputs(engine: Engine, draws: int) -> Row:
    """How far the exact count itself hangs on what the thesis does not print."""
    pairs = over_inputs(engine, draws)
    without, with_feedback = ([pair[k] for pair in pairs] for k in (0, 1))
    fewer = float(np.mean([b < a for a, b in pairs]))
    return claim(
        "A35 S54",
        "feedback lowers the number of transitions, whatever the inputs",
        "3 against 6",
        f"exact, {draws} plausible inputs: {min(without)} to {max(without)} without and "
        f"{min(with_feedback)} to {max(with_feedback)} with feedback; fewer for "
        f"{100 * fewer:.0f} % of them",
        fewer > 0.9,
        share=fewer,
    )


def trust(engine: Engine) -> list[Row]:
    """The exact run: independent of tolerance, and how much it magnifies a small change."""
    coarse, fine, moved = {}, [], []
    for gain in (0.0, 0.16, 0.3, 0.45, 0.6):
        scenario = line(gain=gain)
        y = nominal().line_y
        base = brief(engine(scenario), y)
        loose = brief(engine(scenario.replace(rtol=1e-8, atol=1e-10, max_step=1e-3)), y)
        q = (scenario.q[0] + 1e-6, scenario.q[1])
        shifted = brief(engine(scenario.replace(q=q)), y)
        coarse[gain] = abs(loose.average_error / base.average_error - 1.0)
        fine.append(abs(loose.transitions - base.transitions))
        moved.append(abs(shifted.average_error - base.average_error) * INCH / 1e-6)
    told = ", ".join(f"{difference:.0e} at gain {gain:g}" for gain, difference in coarse.items())
    return [
        claim(
            "A35 A38",
            "error (to a thousandth) and transitions of the exact run do not depend on the "
            "solver's tolerance and step",
            "not said",
            "rtol 1e-10 against 1e-8 with steps of 1 ms at most: relative change of the error "
            f"{told}; transitions within {max(fine)}",
            max(coarse.values()) < 1e-3 and max(fine) == 0,
            why="beyond its border the torque loop magnifies the last digit from sample to sample",
        ),
        claim(
            "A38",
            "the run is not chaotic: a start moved by 1 microradian moves the error alike",
            "not said",
            "change of the average error [m] per change of the start [rad]: up to "
            f"{max(moved):.1f}",
            max(moved) < 100.0,
            why="the link is about 1 m long, so 1 would be the size of the change itself",
        ),
    ]
