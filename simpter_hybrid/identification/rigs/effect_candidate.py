"""A candidate that can be simulated: effects, a load, a stage, or declared numbers that are off."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from itertools import compress
from typing import Any

from ...applied_load import Load
from ...controller import Controller
from ...effect import Effect
from ..fitting.predictor import Candidate


@dataclass(frozen=True)
class EffectCandidate(Candidate):
    """A candidate that changes the scenario; one that changes nothing is a sensor's error.

    Parameters
    ----------
    effect : Effect or None
        The effect that it adds.
    more : tuple of Effect
        Further effects that come with the first (the same on every clutch, say).  A fit's parameter
        ``name.field`` is that field of all of them, ``name.2.field`` that of the second alone.
    labels : tuple of str
        What stands in such names in place of the effects' numbers, if anything.
    load : Load or None
        A load that it adds.
    stages : tuple of Controller
        Stages that it adds behind the controller's others, all with the same fitted numbers.
    shifts : tuple of (str, str, float)
        Declared parameters to which it adds: the fit's parameter, the declared one, and how much of
        the latter one unit of the former is.
    shares : tuple of (str, str)
        Declared parameters that are off by a share: the fit's parameter and the declared one.
    ends_opened : bool
        Whether with it a driver opens its motor's ends: effects on the motor's current know nothing
        of that (`Effect.ends_closed`).
    """

    effect: Effect | None = None
    more: tuple[Effect, ...] = ()
    labels: tuple[str, ...] = ()
    load: Load | None = None
    stages: tuple[Controller, ...] = ()
    shifts: tuple[tuple[str, str, float], ...] = ()
    shares: tuple[tuple[str, str], ...] = ()
    ends_opened: bool = False

    @property
    def frees(self) -> bool:
        """Whether it adds nothing, and sets declared numbers free."""
        adds = bool(self.effects() or self.stages) or self.load is not None
        return not adds and bool(self.shifts or self.shares)

    def effects(self) -> tuple[Effect, ...]:
        """All effects that it adds."""
        return () if self.effect is None else (self.effect, *self.more)

    def has_of(self, label: str, simpler: Candidate) -> bool:
        """Whether an effect of that number is of the kind of a simpler candidate's first."""
        first = simpler.effect if isinstance(simpler, EffectCandidate) else None
        if first is None or self.labels or not label.isdigit():
            return True  # labels are of places, at each of which it is the same effect
        return type(self.effects()[int(label) - 1]) is type(first)

    def fields(self, which: int = 0) -> list[tuple[str, str]]:
        """(name of the fit's parameter, field) of one of its effects."""
        own, found = f"{self.name}.", []
        for name in (p.name for p in self.parameters if p.name.startswith(own)):
            label, dot, field = name.removeprefix(own).rpartition(".")
            if not dot or label == (self.labels[which] if self.labels else str(which + 1)):
                found.append((name, field))
        return found

    def made(self, values: Mapping[str, float]) -> tuple[Effect, ...]:
        """The candidate's effects with fitted values."""
        return tuple(
            replace(e, **{own: values[name] for name, own in self.fields(k)})  # type: ignore[arg-type]
            for k, e in enumerate(self.effects())
        )

    def made_load(self, values: Mapping[str, float]) -> tuple[Load, ...]:
        """The load that the candidate adds, with fitted values, in a tuple; () if it adds none."""
        return () if self.load is None else (replace(self.load, **self._fitted(values)),)

    def made_stages(self, values: Mapping[str, float]) -> tuple[tuple[Controller, int], ...]:
        """The controller's last stages, which the candidate adds, with fitted values."""
        own = self._fitted(values) if self.stages else {}
        return tuple((replace(stage, **own), 1) for stage in self.stages)

    def _fitted(self, values: Mapping[str, float]) -> dict[str, Any]:
        return {own: values[name] for name, own in self.fields()}

    @property
    def places(self) -> tuple[str, ...]:
        """Labels of clutches or joints each of which has numbers of its own."""
        if self.load or self.stages or len({type(e) for e in self.effects()}) > 1:
            return ()
        if self.effect is None and not self.shares:
            return ()
        labels = dict.fromkeys(self._label(p.name) for p in self.parameters)
        return tuple(label for label in labels if label)

    def only(self, places: Collection[str]) -> EffectCandidate:
        """This candidate acting at `places` alone; nothing of it is left at its other places."""
        kept = [self._label(p.name) in ("", *places) for p in self.parameters]
        own = tuple(p for p, k in zip(self.parameters, kept, strict=True) if k)
        gone = {p.name for p in self.parameters} - {p.name for p in own}
        numbers = self.labels or tuple(str(k + 1) for k in range(len(self.effects())))
        acting = [(n, e) for n, e in zip(numbers, self.effects(), strict=True) if n in places]
        on_joint = self.effect is not None and self.effect.coordinate >= 0
        what = "joint" if on_joint else "clutch"
        return replace(
            self, parameters=own,
            starts=tuple(tuple(compress(start, kept)) for start in self.starts),
            sizes=tuple(n for n in self.sizes if n not in gone),
            fitted=tuple((n, v) for n, v in self.fitted if n not in gone),
            shifts=tuple(s for s in self.shifts if s[0] not in gone),
            shares=tuple(s for s in self.shares if s[0] not in gone),
            effect=acting[0][1] if acting else None, more=tuple(e for _, e in acting[1:]),
            labels=tuple(n for n, _ in acting), at=tuple(f"{what} {p}" for p in places),
        )  # fmt: skip

    def _label(self, name: str) -> str:
        """Place that one of the candidate's parameters belongs to; "" if it belongs to all."""
        own = f"{self.name}."
        return name.removeprefix(own).rpartition(".")[0] if name.startswith(own) else ""
