"""4.7, 6.3: what follows the desired torque better than a table, alone or with feedback."""

from __future__ import annotations

from collections.abc import Callable

from ..controller import Controller
from ..controllers.integral_feedback import IntegralFeedback
from ..controllers.inverse_model import InverseModel
from ..controllers.lookup import LookupTable
from ..controllers.torque_feedback import TorqueFeedback
from ..laws import LBF_IN
from ..rigs.inputs import Inputs
from ..rigs.line import line
from .batch import Measured
from .study import Study, Table
from .variants import ABOUT, comparison, pairs, ratio_picture, ratios, side_by_side, verdict

GAIN, INTEGRAL = 0.16 / LBF_IN, 1.0 / LBF_IN
P = "table and P"


def stages() -> dict[str, Callable[[Inputs], tuple[Controller, ...]]]:
    """Clutch controllers by name."""
    return {
        "table": lambda x: (LookupTable(x.table_torque),),
        P: lambda x: (LookupTable(x.table_torque), TorqueFeedback(GAIN)),
        "table, P and integral": lambda x: (
            LookupTable(x.table_torque), TorqueFeedback(GAIN), IntegralFeedback(INTEGRAL),
        ),
        "table and integral": lambda x: (LookupTable(x.table_torque), IntegralFeedback(INTEGRAL)),
        "inverse of (39)": lambda x: (InverseModel(),),
        "inverse, 20 % too weak": lambda x: (InverseModel(scale=1.25),),
        "inverse, 20 % too strong": lambda x: (InverseModel(scale=0.8),),
        "inverse and P": lambda x: (InverseModel(), TorqueFeedback(GAIN)),
        "inverse 20 % off and P": lambda x: (InverseModel(scale=1.25), TorqueFeedback(GAIN)),
    }  # fmt: skip


def torque_control(size: int = 24) -> Study:
    """Integral and model-based torque control behind both torque selectors."""

    def variant(make):
        def build(kind, gain, x):
            scenario = line(kind, 0.0, x)
            chosen = (scenario.controllers[0][0], *make(x))
            return scenario.replace(controllers=tuple((c, 1) for c in chosen))

        return build

    found = side_by_side({k: variant(v) for k, v in stages().items()}, size, ("P", "velocity"))
    found = {({"P": "impedance"}.get(c, c), v): m for (c, v), m in found.items()}
    ranked = sorted(stages(), key=lambda v: pairs(found["impedance", v], found["impedance", P],
                    "error")[0] if v != P else 1.0)  # fmt: skip
    return Study(
        "Integral or model-based torque control: does it do better than proportional feedback?",
        "thesis, sections 5.4.3 (the steady error of proportional feedback), 6.2.2.1 and 6.3.2",
        ABOUT.format(size=size) + " Here every variant of the clutch controller is run behind the "
        "impedance selector and behind the velocity selector. The table is the thesis's lookup "
        "table from desired torque to command. The inverse solves equation (39) for the command at "
        "the clutch's slip speed. The integral has a gain of 1 V/(lb-in s) and an anti-windup.",
        (
            comparison(found, P, "On the line, against proportional feedback"),
            torque_following(found),
        ),
        (
            f"Behind impedance control this variant has the smallest error: {ranked[0]}. The next "
            f"is: {ranked[1]}.",
            "The inverse needs no torque sensor. Compared with table and P it has less error for "
            f"these shares of the plausible inputs: {verdict(found, 'inverse of (39)', P, 'error')}"
            f". It has less jerk for these: {verdict(found, 'inverse of (39)', P, 'jerk')}.",
            "An inverse that is 20 % off, with P around it, has less error than table and P for "
            f"these shares: {verdict(found, 'inverse 20 % off and P', P, 'error')}.",
            "An integral beside P has less error for these shares: "
            f"{verdict(found, 'table, P and integral', P, 'error')}. It has less jerk for these: "
            f"{verdict(found, 'table, P and integral', P, 'jerk')}.",
            "An integral alone, without P, has less error for these shares: "
            f"{verdict(found, 'table and integral', P, 'error')}.",
        ),
        {"ratios": ratios(found, P)},
        ratio_picture(found, P, "Clutch controllers, against table and P"),
        "Each dot is one set of plausible inputs; bars are medians.",
    )


def torque_following(found: dict[tuple[str, str], Measured]) -> Table:
    """How far the torque is from the desired one, by controller and variant."""
    rows = tuple(
        (c, v, f"{m.following[0] / LBF_IN:.0f}", f"{pairs(m, found[c, P], 'following')[0]:.2f}")
        for (c, v), m in found.items()
    )
    return Table(
        "Rms difference between torque and desired torque, while a torque is desired",
        ("controller", "variant", "nominal / lb-in", "median ratio to table and P"),
        rows,
    )
