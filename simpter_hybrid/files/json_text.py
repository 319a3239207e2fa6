"""Strict JSON of results."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import Any

import numpy as np


def json_text(value: Any) -> str:
    """Strict JSON; what is not finite becomes null.

    Parameters
    ----------
    value : object
        Mappings, lists, tuples, texts, Python's and NumPy's numbers.

    Raises
    ------
    TypeError
        If something in it is of another kind.
    """
    return json.dumps(_finite(value), indent=2, allow_nan=False, default=plain) + "\n"


def _finite(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _finite(v) for key, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(v) for v in value]
    if isinstance(value, (float, np.floating)):
        return float(value) if math.isfinite(value) else None
    return value


def plain(value: Any) -> Any:
    """NumPy scalars as Python numbers.

    Parameters
    ----------
    value : object
        What ``json`` does not know.

    Raises
    ------
    TypeError
        If it is no NumPy scalar.
    """
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{type(value).__name__} cannot be stored: {value!r}")
