"""The corrected scenario: declared parameters as fitted, effects added."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any

from ...effect import Effect
from ...scenario import Scenario
from ..fitting.fitted_model import Model
from .effect_candidate import EffectCandidate
from .motor_ties import dead_at_limits, tied_numbers
from .tolerated import REACH

#: How well a size that was found is known, for a diagnosis of the corrected model, and the least
#: tolerance that is worth one.
FOUND, LEAST = 0.2, 0.01


def with_parameters(scenario: Scenario, values: Mapping[str, float]) -> Scenario:
    """The scenario with entries of its parameter vector replaced.

    Parameters
    ----------
    scenario : Scenario
    values : mapping of str to float
        By their names in the parameter vector, e.g. ``clutch.1.torque.scale`` [SI].
    """
    device, clutches, loads = scenario.device, list(scenario.clutches), list(scenario.loads)
    effects, stages = list(scenario.effects), list(scenario.controllers)
    for name, value in values.items():
        kind, _, rest = name.partition(".")
        if kind == "device":
            device = replace(device, **{rest: value})
            continue
        number, _, rest = rest.partition(".")
        k = int(number) - 1
        if kind == "load":
            loads[k] = replace(loads[k], **{rest: value})
        elif kind == "controller":
            stages[k] = (replace(stages[k][0], **{rest: value}), stages[k][1])
        elif kind == "effect":  # effect.1.SpringForce.stiffness
            effects[k] = replace(effects[k], **{rest.rpartition(".")[2]: value})  # type: ignore[arg-type]
        elif rest.startswith("torque."):
            torque = replace(clutches[k].torque, **{rest.partition(".")[2]: value})
            clutches[k] = replace(clutches[k], torque=torque)
        else:
            clutches[k] = replace(clutches[k], **{rest: value})  # type: ignore[arg-type]
    return replace(
        scenario, device=device, clutches=tuple(clutches), loads=tuple(loads),
        effects=tuple(effects), controllers=tuple(stages),
    )  # fmt: skip


def corrected_scenario(
    declared: Scenario, effects: Sequence[EffectCandidate], values: Mapping[str, float]
) -> Scenario:
    """The declared scenario with fitted factors and the effects that were found.

    Its tolerances are kept, so that a diagnosis of the corrected model may refit again.  A load
    that stands for what a sensor adds is none of the model's: `sensor_errors` has it.
    """
    known = dict(zip(declared.parameter_names(), declared.parameter_values(), strict=True))
    fitted: dict[str, float] = {}
    for group in declared.notes.get("tolerances", ()):
        for name in group["parameters"]:
            fitted[name] = fitted.get(name, known[name]) * values[group["name"]]
    for e in effects:
        for own, name, unit in e.shifts:
            fitted[name] = fitted.get(name, known[name]) + unit * values[own]
        for own, name in e.shares:
            fitted[name] = fitted.get(name, known[name]) * (1.0 + values[own])
    added = tuple(effect for e in effects for effect in e.made(values))
    pushing = (e for e in effects if e.acts_on != "sensor")
    loads = tuple(load for e in pushing for load in e.made_load(values))
    stages = tuple(stage for e in effects for stage in e.made_stages(values))
    made = with_parameters(declared, fitted)
    whole = replace(
        made, effects=(*made.effects, *added), loads=(*made.loads, *loads),
        controllers=(*made.controllers, *stages),
    )  # fmt: skip
    ties = tied_numbers(whole, known.__getitem__, lambda name: fitted.get(name, known[name]))
    whole = with_parameters(whole, {n: _of_effect(whole, n) * x for n, x in ties.items()})
    return with_parameters(whole, dead_at_limits(whole, partial(_of_effect, whole)))


def as_written(model: Model) -> Model:
    """The model with its effects' numbers as its scenario has them, which is what was simulated.

    A dead band that was fitted wider than a limit beside it leaves is told as wide as that.
    """
    predictor: Any = model.predictor
    scenario = corrected_scenario(predictor.declared, predictor.effects, model.values)
    added = iter(scenario.effects[len(predictor.declared.effects) :])
    told = {
        name: float(getattr(made, field))
        for e in predictor.effects
        for which, made in zip(range(len(e.effects())), added, strict=False)
        for name, field in e.fields(which)
    }
    if all(value == model.values[name] for name, value in told.items()):
        return model
    return replace(model, values={**model.values, **told})


def _of_effect(scenario: Scenario, name: str) -> float:
    """Number of an effect by its name: ``effect.1.DriveDeadband.width``."""
    _, number, _, field = name.split(".")
    return float(getattr(scenario.effects[int(number) - 1], field))


def with_tolerances(corrected: Scenario, effects: Sequence[EffectCandidate]) -> Scenario:
    """The corrected scenario with a tolerance for every size of an effect that was found.

    Fixed they would be patched by others where a diagnosis of the corrected model refits the rest.
    A size may be refitted as far as the effect allows, so near a limit the tolerance is less than
    `FOUND`.

    Parameters
    ----------
    corrected : Scenario
        Its last effects are theirs.
    effects : sequence of EffectCandidate
        In the order in which the scenario has them.
    """
    groups: dict[str, dict[str, float]] = {}
    number = len(corrected.effects) - sum(len(e.effects()) for e in effects)
    for e in effects:
        for which, effect in enumerate(e.effects()):
            made = corrected.effects[number]
            assert type(made) is type(effect), "the order of effects is the scenario's"
            number += 1
            for name, field in e.fields(which):
                path = f"effect.{number}.{type(effect).__name__}.{field}"
                known = _known_to(made, field)
                if field in type(effect).sizes and known > 0.0:
                    groups.setdefault(name, {})[path] = known
    told = list(corrected.notes.get("tolerances", ()))
    for name, known_to in groups.items():
        # Not the name of a candidate's own number, which may be tried again.
        called, again = f"{name} as found", 1
        while any(called == each["name"] for each in told):
            again += 1
            called = f"{name} as found {again}"
        told.append({"name": called, "parameters": [*known_to], "relative": min(known_to.values())})
    return replace(corrected, notes={**corrected.notes, "tolerances": told})


def _known_to(effect: Effect, field: str) -> float:
    """Relative tolerance of a size that was found; 0 if it is 0 or ends where the effect does."""
    value = getattr(effect, field)
    about = type(effect).__dataclass_fields__[field].metadata
    limit = about["high"] if value > 0.0 else about["low"]
    if value == 0.0 or limit is None:
        return 0.0 if value == 0.0 else FOUND
    room = (limit / value - 1.0) / REACH
    return min(FOUND, room) if room >= LEAST else 0.0
