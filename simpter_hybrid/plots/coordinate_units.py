"""Units of what residuals are drawn along, and of residual forces."""

from __future__ import annotations

import re

from ..identification.result import Diagnosis


def coordinate_unit(name: str, force: str) -> str:
    """SI unit of a coordinate along which a residual is drawn."""
    name = re.sub(r"_\d+$", "", name)  # which clutch's
    way = "m" if force == "N" else "rad"
    units = {
        "time": "s", "heat": "J", "distance": way, "position": way, "speed": f"{way}/s",
        "slip_velocity": f"{way}/s", "acceleration": f"{way}/s\u00b2", "torque": force,
        "displacement_since_reversal": way, "direction": "sign", "excitation": "V",
        "temperature": "K", "command": "V", "other_joint_position": "rad or m",
    }  # fmt: skip
    return units.get(name, "SI")


def coordinate_label(name: str, force: str) -> str:
    """What is written at an axis along which a residual is drawn."""
    called = "force" if name == "torque" and force == "N" else name.replace("_", " ")
    return f"{called} [{coordinate_unit(name, force)}]"


def force_unit(found: Diagnosis) -> str:
    """Unit of residual forces: N where all coordinates of the rig are lengths, else N m."""
    declared = found.search.refitted.predictor.declared  # type: ignore[attr-defined]
    kinds = declared.device.coordinate_dimensions
    return "N" if kinds and set(kinds) == {"length"} else "N m"
