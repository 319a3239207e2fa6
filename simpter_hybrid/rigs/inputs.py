"""The inputs of chapter 5's runs: what is printed, what is inferred, and over which range."""

from __future__ import annotations

import functools
import math
import tomllib
from dataclasses import dataclass, replace
from importlib import resources
from typing import Any

import numpy as np
from scipy.stats import qmc

from ..laws import LBF_IN
from ..units import parse_quantity

#: Field of ``Inputs`` -> its entry in ``devices/pter_parameters.toml``.
ENTRIES = {
    "l_a": "linkage.l_a",
    "l_d": "linkage.l_d",
    "alpha": "linkage.alpha",
    "beta": "linkage.beta",
    "gamma": "linkage.gamma",
    "time_constant": "clutch.time_constant",
    "delay": "clutch.switch_on_delay",
    "line_y": "line.y",
    "stop_x": "line.stop_x",
    "push": "line.force_along_path",
    "normal": "line.force_normal_total",
    "frequencies": "line.sinusoid_frequency",
    "phases": "line.sinusoid_phase",
    "stiffness": "controller.impedance_stiffness",
    "damping": "controller.impedance_damping",
    "table_torque": "controller.table_torque_at_full_scale",
    "heading_distance": "controller.velocity_gain",
    "heading_gain": "controller.velocity_torque_gain",
    "rate": "controller.rate_simulation",
}


@dataclass(frozen=True)
class Inputs:
    """Inputs of a line-following run; SI, but ``heading_gain`` is K_tau in in/rad as in the file.

    The normal force is shared equally by sinusoids of ``frequencies`` [Hz] and ``phases`` [rad].
    """

    l_a: float
    l_d: float
    alpha: float
    beta: float
    gamma: float
    time_constant: float
    delay: float
    line_y: float
    stop_x: float
    push: float
    normal: float
    frequencies: tuple[float, ...]
    phases: tuple[float, ...]
    stiffness: float
    damping: float
    table_torque: float
    heading_distance: float
    heading_gain: float
    rate: float

    def replace(self, **changes: Any) -> Inputs:
        """A copy with fields changed."""
        return replace(self, **changes)

    @property
    def steering_gain(self) -> float:
        """K_tau for a force per torque in 1/m [N m^2/rad]: the file's unit torque is 1 lb-in."""
        return self.heading_gain * LBF_IN


@functools.lru_cache(maxsize=1)
def _file() -> dict[str, Any]:
    source = resources.files("simpter_hybrid.devices") / "pter_parameters.toml"
    return tomllib.loads(source.read_text(encoding="utf-8"))


def entry(path: str) -> dict[str, Any]:
    """One entry of the parameter file.

    Parameters
    ----------
    path : str
        E.g. ``linkage.l_a``; see `ENTRIES`.

    Raises
    ------
    KeyError
        If there is none.
    """
    found = _file()
    for key in path.split("."):
        found = found[key]
    return found


def value(path: str) -> Any:
    """Value of an entry of the parameter file, SI; a tuple where it lists several.

    Parameters
    ----------
    path : str
        As for `entry`.
    """
    found = entry(path)
    if isinstance(found["value"], list):
        return tuple(parse_quantity(text, found["dimension"]) for text in found["value"])
    return parse_quantity(found["value"], found["dimension"])


def nominal() -> Inputs:
    """The nominal inputs."""
    return Inputs(**{name: value(path) for name, path in ENTRIES.items()})


def ranges() -> dict[str, tuple[float, float]]:
    """Plausible range of every inferred input that has one, SI."""
    found = {}
    for name, path in ENTRIES.items():
        its = entry(path)
        if "range" in its:
            low, high = (parse_quantity(text, its["dimension"]) for text in its["range"])
            found[name] = (low, high)
    return found


def drawn(count: int, seed: int = 0, keep: tuple[str, ...] = ()) -> list[Inputs]:
    """Inputs drawn over their plausible ranges (scrambled Sobol points, the same for one seed).

    Ratios matter where a range spans more than a factor of 3 (then its logarithm is uniform). The
    operator's normal force has two to four sinusoids of any frequency and phase.

    Parameters
    ----------
    count : int
    seed : int
    keep : tuple of str
        Fields that stay nominal.
    """
    limits = {k: v for k, v in ranges().items() if k not in keep and k != "frequencies"}
    low, high = (math.log(f) for f in ranges()["frequencies"])
    size = len(limits) + 9
    points = qmc.Sobol(size, seed=np.random.default_rng(seed)).random(_power_of_two(count))
    found = []
    for row in points[:count]:
        changes: dict[str, Any] = {}
        for x, (name, (a, b)) in zip(row, limits.items(), strict=False):
            ratio = a > 0.0 and b > 3.0 * a
            changes[name] = a * (b / a) ** float(x) if ratio else a + (b - a) * float(x)
        if "frequencies" not in keep:
            lines = 2 + int(3.0 * row[-9])
            changes["frequencies"] = tuple(
                math.exp(low + (high - low) * float(x)) for x in row[-8 : -8 + lines]
            )
            changes["phases"] = tuple(2.0 * math.pi * float(x) for x in row[-4:][:lines])
        found.append(nominal().replace(**changes))
    return found


def _power_of_two(count: int) -> int:
    return 1 << max(count - 1, 1).bit_length()
