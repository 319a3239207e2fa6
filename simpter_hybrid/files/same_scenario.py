"""Is a scenario the one of a stored run?  What a run depends on, beside its parameters."""

from __future__ import annotations

import dataclasses
import hashlib
import json
from collections.abc import Mapping
from typing import Any

import numpy as np

from ..scenario import Scenario
from ..trajectory import Trajectory
from .json_text import plain

#: Fields of a scenario that are compared as they are.
FIELDS = ("q", "qd", "t_end", "period", "method", "rtol", "atol", "max_step", "event_limit")


def identity(scenario: Scenario) -> dict[str, Any]:
    """What a run depends on, beside its parameters, by name; ready for JSON.

    Parameters
    ----------
    scenario : Scenario
    """
    off = (0.0,) * scenario.device.m
    parts = [scenario.device, *(clutch.torque for clutch in scenario.clutches), *scenario.loads,
             *(stage for stage, _ in scenario.controllers), *scenario.effects,
             *scenario.stops]  # fmt: skip
    switching = scenario.switching()
    recorded = np.asarray(scenario.rec, dtype="<f8").tobytes()
    found = {
        **{name: getattr(scenario, name) for name in FIELDS},
        **{name: np.asarray(getattr(scenario, name)).tolist() for name in ("q", "qd")},
        "command": np.asarray(off if len(scenario.command) == 0 else scenario.command).tolist(),
        "excitation": np.asarray(
            off if len(scenario.excitation) == 0 else scenario.excitation
        ).tolist(),
        "delay": switching["delay"],
        "threshold": switching["threshold"],
        "parts": [kind_of(part) for part in parts],
        "every how many samples": [every for _, every in scenario.controllers],
        "recorded series (digest)": hashlib.sha256(recorded).hexdigest()[:16],
    }
    return json.loads(json.dumps(found, default=plain))


def kind_of(part: Any) -> str:
    """Class of a part, with its fields of whole numbers: those are no parameters.

    Parameters
    ----------
    part : Part
    """
    others = [f.name for f in dataclasses.fields(part) if f.type not in ("float", float)]
    values = [(name, getattr(part, name)) for name in others]
    whole = [f" {name} {value:d}" for name, value in values if isinstance(value, int)]
    return type(part).__name__ + "".join(whole)


def difference(scenario: Scenario, ran: Mapping[str, Any]) -> str:
    """What is not as it was in the run, in words; empty if all is.

    Parameters
    ----------
    scenario : Scenario
    ran : mapping
        ``identity`` of the scenario that was run.
    """
    for name, value in identity(scenario).items():
        if name in ran and ran[name] != value:
            return f"{name} is {value}, but was {ran[name]} (SI)"
    return ""


def difference_from(scenario: Scenario, run: Trajectory) -> str:
    """As ``difference``, of what the run itself shows.

    Parameters
    ----------
    scenario : Scenario
    run : Trajectory
        With ``scenario`` as its own, which may be another one's.
    """
    end, start = scenario.t_end, list(scenario.q)
    if run.t_end > end or (run.status == "finished" and run.t_end < end):
        return f"t_end is {end}, but the run ended at {run.t_end} (SI)"
    began = run.step_y[0][: len(start)].tolist() if len(run.step_y) else start
    return f"q is {start}, but was {began} (SI)" if began != start else ""
