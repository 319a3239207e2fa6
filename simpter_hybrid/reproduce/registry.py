"""Names of the comparisons, and the figures and tables each answers for."""

from __future__ import annotations

import importlib
import inspect

from .rows import Engine, Row

#: Name of a comparison -> module.function of this package, and what it answers for.
REPRODUCTIONS: dict[str, tuple[str, str]] = {
    "calibration": ("calibration.calibration", "equations (36)-(42), filter of 4.6"),
    "in-place": ("in_place.in_place", "4.2: Gomes's tests on the assembled robot"),
    "torque-bar": ("torque_bar.torque_bar", "4.3, 4.7, Figures 11, 12, 34; equations (31)-(35)"),
    "steps": ("steps.steps", "4.6.1, Figures 15-18, 20-23"),
    "friction-fits": ("friction_fits.friction_fits", "Tables 3, 4, Figures 24-28, 33"),
    "breakaway": ("breakaway.breakaway", "Figures 29-32"),
    "measured": ("measured.measured", "Tables 3, 4, the steps and (43) diagnosed: what is lacking"),
    "ancestor": ("ancestor.ancestor", "2.3: the first simulation, circular path"),
    "baseline": ("baseline.baseline", "Figures 37-40"),
    "gain-sweep": ("gain_sweep.gain_sweep", "Figures 43, 44"),
    "feedback": ("feedback.feedback", "Figures 45-47 and the causes named in 5.4.2"),
    "tables": ("tables.tables", "Tables 5, 6"),
    "tracking": ("tracking.tracking", "Figures 48, 49"),
    "regulation": ("regulation.regulation", "Figure 50"),
    "velocity": ("velocity.velocity", "Figures 51-55, equations (47)-(53)"),
    "lockup": ("lockup.lockup", "5.2.1: a single sinusoid locks the tip"),
    "variants": ("variants.variants", "5.1, 6.2.1, 6.3: what would change"),
    "found-by-exact": ("found_by_exact.found_by_exact", "scatter and transitions: robot or band?"),
}

#: Figures and tables -> name of the comparison.
ALIASES: dict[str, str] = {
    **{f"figure-{k}": "torque-bar" for k in (11, 12, 34)},
    **{f"figure-{k}": "steps" for k in (15, 16, 17, 18, 20, 21, 22, 23)},
    **{f"figure-{k}": "friction-fits" for k in (24, 25, 26, 27, 28, 33)},
    **{f"figure-{k}": "breakaway" for k in (29, 30, 31, 32)},
    **{f"figure-{k}": "baseline" for k in (37, 38, 39, 40)},
    **{f"figure-{k}": "gain-sweep" for k in (43, 44)},
    **{f"figure-{k}": "feedback" for k in (45, 46, 47)},
    **{f"figure-{k}": "tracking" for k in (48, 49)},
    "figure-50": "regulation",
    **{f"figure-{k}": "velocity" for k in (51, 52, 53, 54, 55)},
    **{f"table-{k}": "friction-fits" for k in (3, 4)},
    **{f"table-{k}": "tables" for k in (5, 6)},
}


def resolve(name: str) -> str:
    """Name of a comparison from its own name or that of a figure or table.

    Raises
    ------
    ValueError
        If there is none of that name.
    """
    found = ALIASES.get(name, name)
    if found not in REPRODUCTIONS:
        raise ValueError(
            f"{name!r} is neither a comparison nor a figure or table that has one; comparisons: "
            f"{', '.join(REPRODUCTIONS)}; others: figure-11 ... figure-55, table-3 ... table-6"
        )
    return found


def reproduce(name: str, engine: Engine | None = None, draws: int | None = None) -> list[Row]:
    """Run one comparison with the thesis.

    Parameters
    ----------
    name : str
        One of ``REPRODUCTIONS`` or ``ALIASES``.
    engine : callable, optional
        ``engine(scenario) -> Trajectory``; the reference engine when left out.
    draws : int, optional
        How many sets of plausible inputs stand for those the thesis does not print; each
        comparison has its own default.

    Raises
    ------
    ValueError
        For an unknown name or fewer than two draws.
    """
    if draws is not None and draws < 2:
        raise ValueError(f"draws = {draws}; at least 2 sets of inputs are needed for a share")
    module, function = REPRODUCTIONS[resolve(name)][0].split(".")
    chosen = getattr(importlib.import_module(f".{module}", __package__), function)
    if engine is None:
        from ..engine import simulate as engine  # type: ignore[no-redef]
    if draws is not None and "draws" in inspect.signature(chosen).parameters:
        return chosen(engine, draws)
    return chosen(engine)
