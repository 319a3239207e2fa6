"""On which of the inputs that the thesis does not print a claim hangs."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.stats import spearmanr

from ..rigs.inputs import Inputs, ranges

#: Rank correlations below this are not told: 64 unrelated pairs reach 0.3 once in 60 cases.
TOLD = 0.3
#: Inputs named at most.
MOST = 3
#: Fields of ``Inputs`` in words.
WORDS = {
    "l_a": "length of link A", "l_d": "length of link D", "alpha": "inertia alpha",
    "beta": "inertia beta", "gamma": "inertia gamma", "time_constant": "lag of the clutch",
    "delay": "switch-on delay", "line_y": "height of the line", "stop_x": "stop line",
    "push": "push along the path", "normal": "force across the path",
    "stiffness": "stiffness of the impedance", "damping": "damping of the impedance",
    "table_torque": "torque of the look-up table at full scale",
    "heading_distance": "K_v", "heading_gain": "K_tau", "rate": "rate of the controller",
}  # fmt: skip


def hangs_on(inputs: Sequence[Inputs], margins: Sequence[float]) -> str:
    """The inputs with which a claim's margin goes up and down, strongest first, in words.

    Parameters
    ----------
    inputs : sequence of Inputs
        As drawn.
    margins : sequence of float
        By how much the claim holds for each; below 0 where it does not.

    Returns
    -------
    str
        ``K_tau (-0.62), ...`` with Spearman's rank correlation; empty if none stands out.
    """
    if len(inputs) < 8:
        return ""
    values = np.asarray(margins, dtype=float)
    found = {}
    for name in ranges():
        own = [getattr(x, name) for x in inputs]
        if name in WORDS and np.ptp(own) > 0.0 and np.ptp(values) > 0.0:
            found[name] = float(spearmanr(own, values).statistic)
    told = sorted((n for n in found if abs(found[n]) >= TOLD), key=lambda n: -abs(found[n]))
    return ", ".join(f"{WORDS[n]} ({found[n]:+.2f})" for n in told[:MOST])


def hanging(inputs: Sequence[Inputs], margins: Sequence[float]) -> str:
    """``hangs_on`` as a sentence for a row's ``why``."""
    told = hangs_on(inputs, margins)
    if not told:
        return "no single input that is not printed decides it (rank correlations below 0.3)"
    return f"hangs most on: {told} (rank correlation with the margin of the claim)"
