"""The path a run was to follow, where it has one."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Line:
    """A straight path through (x, y) [m] in the direction ``angle`` [rad]."""

    x: float
    y: float
    angle: float

    def offset(self, points: np.ndarray) -> np.ndarray:
        """Signed distance of ``points`` (N, 2) from the path, positive to its left [m]; (N,)."""
        normal = np.array([-math.sin(self.angle), math.cos(self.angle)])
        return (points - np.array([self.x, self.y])) @ normal

    def outline(self, points: np.ndarray) -> np.ndarray:
        """The piece of the path beside ``points`` (N, 2), for drawing [m]; (2, 2)."""
        along = np.array([math.cos(self.angle), math.sin(self.angle)])
        start = np.array([self.x, self.y])
        reach = (points - start) @ along
        return start + np.outer([min(reach.min(), 0.0), max(reach.max(), 0.0)], along)


@dataclass(frozen=True)
class Circle:
    """A circular path about (x, y) [m] of radius ``radius`` [m]."""

    x: float
    y: float
    radius: float

    def offset(self, points: np.ndarray) -> np.ndarray:
        """Signed distance of ``points`` (N, 2) from the path, positive outside [m]; (N,)."""
        return np.hypot(points[:, 0] - self.x, points[:, 1] - self.y) - self.radius

    def outline(self, points: np.ndarray) -> np.ndarray:
        """The whole circle, for drawing [m]; (181, 2)."""
        turn = np.linspace(0.0, 2.0 * math.pi, 181)
        return np.column_stack(
            [self.x + self.radius * np.cos(turn), self.y + self.radius * np.sin(turn)]
        )


def path_of(numbers: Mapping[str, float]) -> Line | Circle | None:
    """The path that ``x``, ``y`` and ``radius`` or ``angle`` describe; None without them."""
    if "x" not in numbers or "y" not in numbers:
        return None
    if "radius" in numbers:
        return Circle(numbers["x"], numbers["y"], numbers["radius"])
    if "angle" in numbers:
        return Line(numbers["x"], numbers["y"], numbers["angle"])
    return None


def desired_path(scenario) -> Line | Circle | None:
    """The path of a scenario's tip: its note ``path``, else the first that a controller has.

    Raises
    ------
    TypeError
        If the note is neither a path nor the numbers of one.
    """
    if "tip" not in scenario.device.functions():
        return None
    noted = scenario.notes.get("path")
    if isinstance(noted, Line | Circle):
        return noted
    if isinstance(noted, Mapping):
        return path_of(noted)
    if noted is not None:
        raise TypeError(
            f'notes["path"]: {noted!r} is no path; give a Line, a Circle, or numbers such as '
            '{"x": 0.0, "y": 0.61, "angle": 0.0} (or "radius"), in m and rad'
        )
    found = (path_of(controller.parameters()) for controller, _ in scenario.controllers)
    return next((path for path in found if path is not None), None)
