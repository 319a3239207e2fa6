"""Names of the studies."""

from __future__ import annotations

import importlib

from .study import Study

#: Name -> module.function of this package, and what it asks.
STUDIES: dict[str, tuple[str, str]] = {
    "measurements": ("measurements.measurements", "noisy and quantised measurements"),
    "gradual": ("gradual.gradual", "velocity controller that applies and releases gradually"),
    "delrin": ("delrin.delrin", "a smaller gap between static and sliding friction"),
    "supply": ("supply.supply", "a stronger supply, and the supply's fast mode"),
    "torque-sensing": ("torque_sensing.torque_sensing", "torque feedback at 30, 150, 1000 Hz"),
    "other-brakes": ("other_brakes.other_brakes", "magnetorheological brakes"),
    "torque-control": ("torque_control.torque_control", "integral and model-based control"),
    "standard-input": ("standard_input.standard_input", "one force for robot and simulation"),
}

#: The fewest runs from which a share or a scatter is told.
FEWEST = 2


def study(name: str, size: int | None = None) -> Study:
    """Run one study.

    Parameters
    ----------
    name : str
        One of ``STUDIES``.
    size : int, optional
        How many seeds or sets of plausible inputs; 24 when left out.

    Raises
    ------
    ValueError
        For an unknown name or fewer than two.
    CompiledUnavailable
        If the compiled engine cannot be had.
    """
    if name not in STUDIES:
        raise ValueError(f"{name!r} is no study; there are {', '.join(STUDIES)}")
    if size is not None and size < FEWEST:
        raise ValueError(f"size {size}: at least {FEWEST} runs are needed for a share")
    module, function = STUDIES[name][0].split(".")
    chosen = getattr(importlib.import_module(f".{module}", __package__), function)
    return chosen() if size is None else chosen(size)
