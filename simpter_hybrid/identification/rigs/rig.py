"""What a rig is: how a record drives a scenario, and what its sensors make of the motion."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from typing import Any, Protocol

import numpy as np

from ...applied_load import Load
from ...controller import Controller
from ...device import Device
from ...problems import Problems
from ...scenario import Scenario
from ..fitting.replay import Replay
from .beside_record import check_beside
from .scenario_runner import ScenarioRunner
from .sensor_errors import Key, told_errors

#: How replays are solved: steps that end at a record's rows are so short that order eight would
#: gain nothing for its twelve stages.  A pendulum let alone for 20 s is 1e-5 rad off its course so,
#: and 1e-3 rad at a hundred times these tolerances.  A replay ends with its record: where a run of
#: the model's own would stop is no end of one.
SOLVER: dict[str, Any] = {"method": "RK45", "rtol": 1e-7, "atol": 1e-9, "stops": ()}


def handed_on(
    declared: Scenario, period: float | None = None
) -> tuple[tuple[Controller, int], ...]:
    """Stages of the model's controller that act on what was recorded too: its delays.

    Parameters
    ----------
    declared : Scenario
    period : float, optional
        At which a record is played [s]; default the model's own.

    Raises
    ------
    InvalidInput
        If one delays by more than the samples that it keeps.
    """
    stages = [stage for stage, _ in declared.controllers if stage.hands_on]
    problems = Problems(declared.name)
    for stage in stages:
        longest = (stage.kept_samples - 1) * (period or declared.period)
        if (delay := getattr(stage, "delay", 0.0)) > longest:
            right = f"at most {longest:g} s, as this record is played"
            problems.add(("controller",), "beyond the past that is kept", f"{delay:g} s", right)
    problems.raise_if_any()
    return tuple((stage, 1) for stage in stages)


def driven_by(
    declared: Scenario, stages: Sequence[tuple[Controller, int]], loads: Sequence[Load], **other
) -> Scenario:
    """A declared scenario with what a record replaces replaced.

    Parameters
    ----------
    declared : Scenario
    stages : sequence of (Controller, int)
        Controllers that play the record, and those that act on it.
    loads : sequence of Load
        The declared ones, each in its place or what replaces it: a number of a load has the same
        name in the driven model.
    **other
        Further fields.

    Raises
    ------
    InvalidInput
        As `check_beside` does.
    """
    driven = replace(declared, controllers=tuple(stages), loads=tuple(loads), **SOLVER, **other)
    check_beside(declared, driven)
    return driven


class Rig(Protocol):
    """One kind of rig; a predictor knows no more of it than this."""

    def template(self, declared: Scenario) -> Scenario:
        """The declared scenario driven by the record.

        Raises
        ------
        InvalidInput
            If it cannot be driven so.
        """
        ...

    def driven(self, replay: Replay, values: Mapping[str, float]) -> Replay:
        """The run with the inputs that sensors with such errors must have seen.

        `values` are a fit's parameters by name; unless a rig says otherwise sensors are exact.
        """
        return replay

    def period(self, replay: Replay, period: float, staged: bool = False) -> float:
        """How often the record is read [s].

        `period` is the template's own base period; `staged` says whether a candidate's stage acts
        on what is read.
        """
        return period

    def pack(self, replay: Replay, period: float) -> np.ndarray:
        """The record as the template's controllers and loads read it."""
        ...

    def told_in_motion(self, replay: Replay) -> Mapping[int, float]:
        """First input of the drive of each coordinate that moves as the run begins [V]."""
        return {}

    def told_nothing_before(self, replay: Replay) -> Collection[int]:
        """Coordinates that rest as the run begins, and whose first drive is new to them then."""
        return ()

    def start(self, replay: Replay) -> np.ndarray | None:
        """q and qd at the first sample; None: as the template begins."""
        ...

    def excited(self, replay: Replay) -> float | Sequence[float] | None:
        """Excitation with which the first clutch, or each, begins, as if commanded so for long [V].

        None: as the template begins.
        """
        return None

    def restarts(self, replay: Replay) -> Sequence[tuple[float, tuple[float, ...]]]:
        """Instants [s] at which the motion is set from the record, with q and qd."""
        ...

    def channels(
        self, runner: ScenarioRunner, replay: Replay, parameters: np.ndarray, data, rows: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Exact values (samples,) of what was observed, and what tracing asks for [SI]."""
        ...

    def read(
        self, replay: Replay, values: Mapping[str, float], channels: dict[str, np.ndarray]
    ) -> None:
        """Turn exact values into what sensors with such errors would show, in place."""
        return

    def declared_sensor_errors(self, declared: Scenario) -> dict[str, float]:
        """Errors of sensors that the declared ``[readings]`` tell, as a fit's parameters.

        Raises
        ------
        InvalidInput
            For those that such a rig cannot take into account.
        """
        told_errors(declared, ())
        return {}

    def errors(self, values: Mapping[str, float], device: Device) -> dict[Key, float]:
        """Errors of sensors as ``[readings]`` say them."""
        return {}
