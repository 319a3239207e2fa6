"""A scenario as a predictor: the declared model and its effects, replayed on recorded runs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, partial

import numpy as np

from ...assembly.clutch_text import closes_loop
from ...assembly.model import WiringError
from ...checks.effect_check import check_effects
from ...effect import Effect
from ...problems import Problems
from ...scenario import Scenario
from ..fitting.effort import AROUND, Effort
from ..fitting.predictor import Candidate, Parameter
from ..fitting.replay import Replay
from .begun_at_rest import delayed_from_rest
from .declared_off import shared_numbers
from .effect_candidate import EffectCandidate
from .following import begun_in_motion, following, with_room
from .free_start import begun_near
from .motor_ties import follow_motor
from .packed import packed
from .rig import Rig
from .scenario_runner import GivenRun, ScenarioRunner, in_threads
from .sensor_errors import with_errors
from .simulated_runs import SimulatedRun, simulated_runs
from .tolerated import tolerated

#: What was declared is taken to be so to within so many tolerances.
WITHIN = 2.0


def _is_last(candidate: EffectCandidate) -> bool:
    """Whether its friction is solved for together with all other friction."""
    return any(closes_loop(e, port) for e in candidate.effects() for port in e.functions())


def _remembers(effect: Effect) -> bool:
    asked = (f.__code__ for f in effect.functions().values())
    of_time = any("time" in code.co_varnames[: code.co_argcount] for code in asked)
    # What follows a channel is given each piece's own course.
    return bool(effect.states or effect.modes or (of_time and not effect.follows()))


@dataclass(frozen=True)
class ScenarioPredictor:
    """Replays recorded runs with a scenario.

    Parameters
    ----------
    declared : Scenario
        As read from the model's file; its notes hold the tolerances.
    rig : Rig
    effects : tuple of EffectCandidate
        Added so far.
    effort : Effort
        Counts the steps of all that extends this model.
    wider : tuple of Parameter
        Declared parameters with other bounds than their tolerances give (`with_wider`).
    """

    declared: Scenario
    rig: Rig
    effects: tuple[EffectCandidate, ...] = ()
    effort: Effort = field(default_factory=Effort, compare=False)
    wider: tuple[Parameter, ...] = ()

    @cached_property
    def parameters(self) -> tuple[Parameter, ...]:
        """Factors on declared groups of parameters, then the effects' own."""
        found = [tolerated(group) for group in self.declared.notes.get("tolerances", ())]
        wider = {p.name: p for p in self.wider}
        found = [wider.get(p.name, p) for p in found]
        own = {p.name: p for e in self.effects for p in e.parameters}
        return (*(p for p in found if p.name not in own), *own.values())

    def extended(self, candidate: Candidate) -> ScenarioPredictor:
        """This model with one more effect, put before those that have to be the last."""
        assert isinstance(candidate, EffectCandidate)
        effects = sorted((*self.effects, candidate), key=_is_last)  # keeps the order of the rest
        return replace(self, effects=tuple(effects))

    def with_wider(self, parameters: Sequence[Parameter]) -> ScenarioPredictor:
        """This model with these parameters in place of declared ones of their names."""
        return replace(self, wider=tuple(parameters))

    def absorbed(self, candidate: Candidate, values: Mapping[str, float]) -> dict[str, float]:
        """Values with which this model does what one with the candidate does, if it can.

        A share by which declared numbers are off is taken up by the factors of these numbers; not
        if one of them went farther than `WITHIN` tolerances: then it is a finding.
        """
        assert isinstance(candidate, EffectCandidate)
        found, shared = dict(values), shared_numbers(self.declared, candidate.shares)
        for t in self.declared.notes.get("tolerances", ()):
            shares = {shared.get(number) for number in t["parameters"]}
            own = shares.pop()
            if not shares and own is not None:
                found[t["name"]] = values[t["name"]] * (1.0 + values[own])
                if abs(found[t["name"]] - 1.0) > WITHIN * t["relative"]:
                    return dict(values)
        return found

    def combines(self, candidate: Candidate) -> bool:
        """Whether the effect goes together with those that the model has."""
        extended, problems = self.extended(candidate), Problems(self.declared.name)
        parts = (*self.declared.effects, *(part for e in extended.effects for part in e.effects()))
        opened = [e for e in extended.effects if e.ends_opened]
        if any(part.ends_closed and part not in e.effects() for e in opened for part in parts):
            return False
        made = extended.driven
        check_effects(made, problems)
        try:
            _ = made.text
        except WiringError:
            return False
        return not len(problems)

    def scenario(self, values: Mapping[str, float]) -> Scenario:
        """The declared scenario with fitted values and effects: what other commands run."""
        from .corrected import corrected_scenario

        made = corrected_scenario(self.declared, self.effects, values)
        if not any(e.acts_on == "sensor" for e in self.effects):
            return made
        return with_errors(made, self.rig.errors(self.sensed(values), self.declared.device))

    @cached_property
    def declared_sensor_errors(self) -> dict[str, float]:
        """Errors of sensors that the declared model tells of."""
        return self.rig.declared_sensor_errors(self.declared)

    def sensed(self, values: Mapping[str, float]) -> Mapping[str, float]:
        """Fitted values with what is declared of the sensors added: a fit finds what is more."""
        if not self.declared_sensor_errors:
            return values
        return {
            **values,
            **{name: values.get(name, 0.0) + v for name, v in self.declared_sensor_errors.items()},
        }

    @property
    def driven(self) -> Scenario:
        """The declared scenario with its effects, driven by the record."""
        template = self.rig.template(self.declared)
        added = tuple(effect for e in self.effects for effect in e.effects())
        loads = tuple(e.load for e in self.effects if e.load is not None)
        stages = tuple((stage, 1) for e in self.effects for stage in e.stages)
        effects = with_room((*template.effects, *added))
        return replace(
            template, effects=effects, loads=(*template.loads, *loads),
            controllers=(*template.controllers, *stages),
        )  # fmt: skip

    @cached_property
    def _stages(self) -> int:
        """Stages of the declared model that act on a record."""
        return len(self.rig.template(self.declared).controllers)

    @cached_property
    def runner(self) -> ScenarioRunner:
        """The compiled model."""
        return ScenarioRunner(self.driven, sized=not self.effects)

    @cached_property
    def remembers(self) -> bool:
        """Whether what was before a piece matters: to a part with states, or to one of time.

        Parts of the declared model count as well: else an effect that remembers would mend what
        begins anew without it.
        """
        driven = self.driven
        lags = any(c.time_constant > 0.0 or c.delay > 0.0 for c in driven.clutches)
        stages = any(stage.memory for stage, _ in driven.controllers)
        return lags or stages or any(_remembers(effect) for effect in driven.effects)

    def vector(self, values: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray]:
        """Parameter vector, and delays and thresholds, for fitted values."""
        runner = self.runner
        p = runner.default.copy()
        for t in self.declared.notes.get("tolerances", ()):
            for name in t["parameters"]:
                p[runner.names[name]] *= values[t["name"]]
        for e in self.effects:
            for own, name, unit in e.shifts:
                p[runner.names[name]] += unit * values[own]
            for own, name in e.shares:
                p[runner.names[name]] *= 1.0 + values[own]
        scenario = runner.scenario
        pushes = [e for e in self.effects if e.load is not None]
        stages = [e for e in self.effects for _ in e.stages]
        added = {"load": (scenario.loads, pushes), "controller": (scenario.controllers, stages)}
        for kind, (every, some) in added.items():
            for number, e in enumerate(some, len(every) - len(some) + 1):
                for name, own in e.fields():
                    p[runner.names[f"{kind}.{number}.{own}"]] = values[name]
        k = len(scenario.effects) - sum(len(e.effects()) for e in self.effects)
        made = list(scenario.effects)
        for e in self.effects:
            for which, effect in enumerate(e.made(values)):
                prefix = f"effect.{k + 1}.{type(effect).__name__}"
                for name, own in e.fields(which):
                    p[runner.names[f"{prefix}.{own}"]] = values[name]
                made[k] = effect
                k += 1
        follow_motor(p, runner.default, runner.names, scenario)
        switching = replace(scenario, effects=tuple(made)).switching()
        return p, np.array([*switching["delay"], *switching["threshold"]], dtype=float)

    def predict(
        self, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[np.ndarray]]:
        """Channel -> one array (samples,) for each replay [SI]; NaN where the model failed.

        Runs whose start is free begin as is best for this model, near where they say.
        """
        return begun_near(self.simulated, values, replays)

    def _with_more(
        self, p: np.ndarray, values: Mapping[str, float], added: Mapping[str, float]
    ) -> np.ndarray:
        """Add the run's known constants (`adds_to`) to the parameter vector.

        Each is scaled by the fitted factor of its parameter, and by the share by which it is off:
        both hold for the whole.
        """
        if not added:
            return p
        p = p.copy()
        for name, more in added.items():
            groups = self.declared.notes.get("tolerances", ())
            times = [values[t["name"]] for t in groups if name in t["parameters"]]
            times += [1.0 + values[own] for e in self.effects for own, of in e.shares if of == name]
            p[self.runner.names[name]] += more * float(np.prod(times))
        return p

    def played(
        self,
        values: Mapping[str, float],
        run: Replay,
        common: tuple[np.ndarray, np.ndarray] | None = None,
    ) -> tuple[Replay, GivenRun]:
        """A run as it is driven, and what is simulated of it.

        `common`: the vector of these values, where it is known.
        """
        signed = {p.name for p in self.parameters if p.signed} if run.own else ()
        own = {n: values[n] + x if n in signed else values[n] * x for n, x in run.own.items()}
        p, switching = self.vector({**values, **own}) if own or common is None else common
        names, effects = self.runner.names, self.runner.scenario.effects
        p = self._with_more(following(p, names, effects, run), {**values, **own}, run.added)
        replay = self.rig.driven(run, self.sensed(values))
        p = begun_in_motion(p, names, effects, partial(self.rig.told_in_motion, replay))
        scenario, alone = self.runner.scenario, self._stages == 1
        # Another stage of the model's may act between the rows.
        staged = len(scenario.controllers) > 1 if alone else None
        period, data = packed(self.rig, replay, scenario.period, staged)
        resting = partial(self.rig.told_nothing_before, replay)
        p = delayed_from_rest(p, names, scenario.controllers, period, resting)
        restarts, start = self.rig.restarts(replay), self.rig.start(replay)
        given = GivenRun(
            p, switching, data, replay.time, restarts, start, period, self.rig.excited(replay)
        )
        return replay, given

    def simulated(
        self, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[np.ndarray]]:
        """Channel -> one array (samples,) for each replay [SI], each run begun as it says."""
        common, of_sensors = self.vector(values), self.sensed(values)

        def one(made: SimulatedRun) -> tuple[Replay, dict[str, np.ndarray], int]:
            replay, given = self.played(values, made.run, common)
            rows, steps = self.runner.run(given._replace(pieces=made.pieces))
            told = self.rig.channels(self.runner, replay, given.parameters, given.data, rows)
            return replay, told, steps

        found: dict[str, list[np.ndarray]] = {}
        runs = simulated_runs(replays, self.remembers)
        for made, (driven, channels, steps) in zip(runs, in_threads(one, runs), strict=True):
            self.effort.add(steps + AROUND)
            for i, first in made.parts:
                shown = {n: v[first : first + replays[i].time.size] for n, v in channels.items()}
                alone = driven if made.run is replays[i] else replays[i]
                self.rig.read(alone, of_sensors, shown)
                for name, series in shown.items():
                    found.setdefault(name, [np.zeros(0)] * len(replays))[i] = series
        return found
