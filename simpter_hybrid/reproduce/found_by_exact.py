"""What the band hides or invents: scatter over the gain and the number of transitions."""

from __future__ import annotations

import functools

import numpy as np

from ..karnopp import FAIR, THESIS
from ..karnopp import simulate as karnopp
from ..rigs.inputs import INCH, drawn, nominal
from ..rigs.line import line
from ..trajectory import Trajectory
from .gain_sweep import GAINS, point, scatter, swept
from .rows import Engine, Row, claim
from .standard import brief

#: Bands of the Karnopp runs [rad/s]; the thesis does not print its own.
BANDS = (1e-2, 1e-3, 1e-4)
#: SIMULINK's defaults, which the thesis does not print either.
SIMULINK = {"rtol": 1e-3, "atol": 1e-6}


def banded(rules_name: str, band: float, rtol: float = 1e-3):
    """Karnopp's model with a band as an engine; compiled where Numba is there."""
    return _banded(rules_name, band, rtol)


@functools.lru_cache(maxsize=32)
def _banded(rules_name: str, band: float, rtol: float):
    rules = THESIS if rules_name == "thesis" else FAIR

    def engine(scenario) -> Trajectory:
        return karnopp(
            scenario, band, rules=rules, rtol=rtol, atol=1e-3 * rtol, compiled=_compiles()
        )

    return engine


@functools.lru_cache(maxsize=1)
def _compiles() -> bool:
    try:
        import numba  # noqa: F401
    except ImportError:
        return False
    return True


def sweeps(engine: Engine) -> dict[str, tuple[np.ndarray, np.ndarray]]:
    """Error [in] and jerk [in/s^3] over the gains, exact and with bands."""
    found = {"exact": columns(swept(engine))}
    for rules in ("thesis", "fair"):
        for band in BANDS[1:]:
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
    return [*scatters(engine, draws), *transition_counts(engine), *trust(engine)]


def scatters(engine: Engine, draws: int) -> list[Row]:
    """Is the scatter above gain 0.2 the robot's or the simulator's?"""
    gains = np.array(GAINS)
    high = gains >= 0.2
    found = sweeps(engine)
    jerk = {n: scatter(gains[high], j[high]) for n, (_, j) in found.items()}
    error = {n: scatter(gains[high], e[high]) for n, (e, _) in found.items()}
    text = "; ".join(f"{n}: error {error[n]:.3f}, jerk {jerk[n]:.3f}" for n in found)
    others = [v for n, v in jerk.items() if n != "exact"]
    rough = []
    for inputs in drawn(draws, seed=44):
        points = [point(engine, g, inputs, False) for g in GAINS[::2]]
        e, j = columns(points)
        top = gains[::2] >= 0.2
        low = gains[::2] <= 0.2
        rough.append(
            scatter(gains[::2][top], j[top]) > 1.5 * scatter(gains[::2][low], j[low])
            and scatter(gains[::2][top], e[top]) > 1.5 * scatter(gains[::2][low], e[low])
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


def transition_counts(engine: Engine) -> list[Row]:
    """How many transitions each simulator counts in the same two runs."""
    rows = []
    for gain, printed in ((0.0, 6), (0.16, 3)):
        scenario = line(gain=gain)
        y = nominal().line_y
        exact = brief(engine(scenario), y)
        counts = {
            (rules, band, rtol): brief(banded(rules, band, rtol)(scenario), y)
            for rules in ("thesis", "fair")
            for band in BANDS
            for rtol in (1e-3, 1e-6)
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
    return rows


def trust(engine: Engine) -> list[Row]:
    """The exact run: independent of tolerance, and how much it magnifies a small change."""
    coarse, fine, moved = [], [], []
    for gain in (0.0, 0.16, 0.3, 0.45, 0.6):
        scenario = line(gain=gain)
        y = nominal().line_y
        base = brief(engine(scenario), y)
        loose = brief(engine(scenario.replace(rtol=1e-7, atol=1e-9)), y)
        q = (scenario.q[0] + 1e-6, scenario.q[1])
        shifted = brief(engine(scenario.replace(q=q)), y)
        coarse.append(abs(loose.average_error / base.average_error - 1.0))
        fine.append(abs(loose.transitions - base.transitions))
        moved.append(abs(shifted.average_error - base.average_error) * INCH / 1e-6)
    return [
        claim(
            "A35 A38",
            "error and transitions of the exact run do not depend on the solver's tolerance",
            "not said",
            f"rtol 1e-10 against 1e-7: error within {max(coarse):.1e} (relative), transitions "
            f"within {max(fine)}, at five gains",
            max(coarse) < 1e-4 and max(fine) == 0,
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
