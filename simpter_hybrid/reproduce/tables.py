"""Tables 5 and 6: the measures of three controllers, and the orderings the text draws from them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import pairwise

import numpy as np

from ..known_units import INCH
from ..measuring.metrics import Metrics
from ..rigs.inputs import drawn
from .rows import Engine, Row, claim, uncomparable
from .sensitivity import hanging
from .standard import COARSE, Brief, plausible, table

#: Table 6 (its first two rows are Table 5's), in and s.
PRINTED = {
    "baseline": (0.360, 1.078, 456.0, 40118.0, 32.205, 31.53, 139.8),
    "P": (0.132, 0.299, 317.0, 3501.0, 31.154, 17.58, 79.69),
    "velocity": (0.067, 0.161, 439.0, 49774.0, 31.034, 15.77, 42.18),
}
#: Field of ``Metrics`` and of ``Brief``, words, unit.
COLUMNS = (
    ("average_error", "average position error", "in"),
    ("max_error", "largest position error", "in"),
    ("average_jerk", "average jerk", "in/s^3"),
    ("max_jerk", "largest jerk", "in/s^3"),
    ("path_length", "path length", "in"),
    ("average_acceleration", "average acceleration", "in/s^2"),
    ("max_acceleration", "largest acceleration", "in/s^2"),
)
ITEMS = {"baseline": "A32", "P": "A33", "velocity": "A34"}
NAMES = {
    "baseline": "baseline",
    "P": "impedance with feedback 0.16",
    "velocity": "velocity control",
}
FITTED = (
    "about twelve inputs the thesis does not print were inferred from these very tables; closeness "
    "validates nothing"
)

#: Claims of 5.4.2 and 5.5.2 as orderings, from the smallest to the largest.
ORDERINGS = (
    (
        "average_error",
        ("velocity", "P", "baseline"),
        "both new controllers track better, in this order",
    ),
    ("path_length", ("velocity", "P", "baseline"), "path length falls alike"),
    ("average_jerk", ("P", "baseline"), "feedback lowers the average jerk"),
    (
        "average_jerk",
        ("P", "velocity"),
        "velocity control is less smooth than impedance with feedback",
    ),
    ("average_jerk", ("P", "velocity", "baseline"), "average jerk in the order of Table 6"),
    (
        "average_acceleration",
        ("velocity", "P", "baseline"),
        "average acceleration in the order of Table 6",
    ),
    (
        "max_acceleration",
        ("velocity", "P", "baseline"),
        "largest acceleration in the order of Table 6",
    ),
    ("transitions", ("P", "baseline"), "feedback lowers the number of transitions (3 against 6)"),
)


def in_order(of: Callable[[str], float], order: tuple[str, ...]) -> bool:
    """Whether a measure rises strictly along ``order``."""
    values = [of(name) for name in order]
    return all(a < b for a, b in pairwise(values))


def tables(engine: Engine, draws: int = 64) -> list[Row]:
    """Every entry of Tables 5 and 6, then every ordering."""
    nominal = table(engine)
    pairs = [
        (inputs, runs)
        for inputs, runs in zip(drawn(draws), plausible(engine, draws), strict=True)
        if all(r.finished for r in runs.values())
    ]
    every = [runs for _, runs in pairs]
    rows = [reach(engine, draws)]
    for name in PRINTED:
        rows += entries(name, nominal[name], [runs[name] for runs in every])
    return rows + [ordering(f, o, w, nominal, pairs) for f, o, w in ORDERINGS]


def reach(engine: Engine, draws: int) -> Row:
    """How often the three controllers let the operator reach the stop line at all."""
    runs = plausible(engine, draws)
    parts = {n: sum(r[n].finished for r in runs) / len(runs) for n in PRINTED}
    text = ", ".join(f"{NAMES[n]} {100 * share:.0f} %" for n, share in parts.items())
    late = [NAMES[n] for n, m in table(engine).items() if m.run_time >= 12.0]
    reached = f"no, not with {' and '.join(late)}" if late else "yes"
    return claim(
        "A31 S49",
        "the standard run reaches x = -28 in with each controller",
        "yes",
        f"nominal: {reached}; over {draws} plausible inputs: {text}",
        not late,
        share=sum(all(r[n].finished for n in PRINTED) for r in runs) / len(runs),
        **parts,  # type: ignore[arg-type]
    )


def entries(name: str, ours: Metrics, every: list[Brief]) -> list[Row]:
    """One row for every column of a controller."""
    rows = []
    for (field, words, unit), printed in zip(COLUMNS, PRINTED[name], strict=True):
        value = getattr(ours, field) / INCH
        if field == "max_jerk":
            why = "acceleration jumps at transitions: the largest difference measures the step"
            rows.append(
                uncomparable(
                    ITEMS[name],
                    f"{words}, {NAMES[name]}",
                    f"{printed:g} {unit}",
                    f"{value:.4g} {unit} at 1 ms",
                    why,
                    ours_value=value,
                )
            )
            continue
        drawn = np.array([getattr(runs, field) for runs in every])
        low, high = np.quantile(drawn, [0.05, 0.95])
        inside = "inside" if low <= printed <= high else "outside"
        why = FITTED + at_steps(field)
        if field == "average_jerk":
            why += "; the average of differences depends on the sampling, which is not printed"
        rows.append(
            uncomparable(
                ITEMS[name],
                f"{words}, {NAMES[name]}",
                f"{printed:g} {unit}",
                f"{value:.4g} {unit}; plausible inputs {low:.3g} to {high:.3g} {unit} "
                f"(the printed value is {inside})",
                why,
                ours_value=value,
                low=float(low),
                high=float(high),
            )
        )
    return rows


def at_steps(field: str) -> str:
    """For a ``why``: the steps at which a measure of acceleration or jerk is taken."""
    if not field.endswith(("jerk", "acceleration")):
        return ""
    return f"; sampled at 1 ms at nominal inputs, at {1e3 * COARSE:g} ms over the plausible ones"


def margin(runs: Mapping[str, Brief], field: str, order: tuple[str, ...]) -> float:
    """By how much a measure rises along ``order``: the least ratio of neighbours, less 1."""
    values = [getattr(runs[name], field) + 1e-12 for name in order]
    return min(b / a for a, b in pairwise(values)) - 1.0


def ordering(field: str, order: tuple[str, ...], words: str, nominal, pairs) -> Row:
    """One ordering: its verdict at the nominal inputs and its share over the plausible ones."""
    every = [runs for _, runs in pairs]
    margins = [margin(runs, field, order) for runs in every]
    holds = [
        in_order({n: getattr(runs[n], field) for n in order}.__getitem__, order) for runs in every
    ]
    share = float(np.mean(holds))
    scale = 1.0 if field == "transitions" else INCH
    text = " < ".join(f"{NAMES[n]} {getattr(nominal[n], field) / scale:.4g}" for n in order)
    condition = in_order(lambda n: getattr(nominal[n], field), order)
    why = "" if condition else "at the nominal inputs the order is another one; "
    why += hanging([inputs for inputs, _ in pairs], margins) + at_steps(field)
    return claim(
        "A35 S64" if order == ("P", "baseline") else "A35",
        words,
        " < ".join(NAMES[n] for n in order),
        f"{'' if condition else 'not '}{text}; holds for {100 * share:.0f} % of {len(every)} "
        "plausible inputs",
        condition,
        why=why,
        share=share,
    )
