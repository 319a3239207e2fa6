"""What a fit may do to numbers that were declared with a tolerance."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..fitting.predictor import Parameter
from .zeros import are_zeros

#: A declared value is refitted by so many of its tolerances at most.
REACH = 3.5
#: Size of a change of a declared value that matters, in tolerances.
TYPICAL = 0.25
#: The least factor on what has a meaning at zero only.
LEAST = 0.05


def tolerated(group: Mapping[str, Any]) -> Parameter:
    """The factor on all numbers of a tolerance; one on zeros may be of the other sign."""
    relative, signed = group["relative"], are_zeros(group["parameters"])
    lower = 1 - REACH * relative
    return Parameter(
        group["name"], 1.0, lower if signed else max(LEAST, lower), 1 + REACH * relative,
        TYPICAL * relative, relative, "1", signed,
    )  # fmt: skip
