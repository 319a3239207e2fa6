"""What identification asks of a simulator: parameters in, channels out."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np

from .replay import Replay

#: Channel of a prediction: which part of each sample it does not tell (0, or not at all: 1), and
#: repeats of what was measured.
UNTOLD = "untold"
#: A value is at a limit up to this part of the way there.
AT_LIMIT = 1e-3


@dataclass(frozen=True)
class Parameter:
    """A number that may be fitted.

    Parameters
    ----------
    name : str
    value : float
        Declared value, or the value at which an effect does nothing [SI].
    lower, upper : float
        Bounds of the fit [SI].
    typical : float
        Size of a change that matters; scales steps and finite differences [SI].
    tolerance : float
        Standard deviation to which `value` is declared [SI]; inf: nothing is known beforehand.
    unit : str
        SI unit, for reports.
    signed : bool
        Whether its zero has no meaning (a place of rest): values of runs differ from one another by
        amounts of either sign, not by factors.
    """

    name: str
    value: float
    lower: float
    upper: float
    typical: float
    tolerance: float = np.inf
    unit: str = ""
    signed: bool = False

    def at_limit(self, value: float) -> bool:
        """Whether a fitted value ended at a bound, which is then no estimate."""
        ends = (end for end in (self.lower, self.upper) if end != self.value)
        return any(abs(value - end) <= AT_LIMIT * abs(end - self.value) for end in ends)

    def difference(self, value: float, size: float, lower: float | None = None) -> float:
        """Step of a finite difference from a value, within the bounds.

        It is as long as it may be where neither way has room for all of it: beyond a bound a model
        may be none (a lag below zero).

        Parameters
        ----------
        value : float
            From where [SI].
        size : float
            How far, if there is room; upwards if it is there [SI].
        lower : float, optional
            Lower bound in place of the fit's [SI].
        """
        least = self.lower if lower is None else lower
        if value + size <= self.upper:
            return size
        if value - size >= least:
            return -size
        up, down = self.upper - value, value - least
        return (up if up >= down else -down) or -size  # what is held by both bounds has no room


@dataclass(frozen=True)
class Candidate:
    """An effect that the declared model might lack.

    Parameters
    ----------
    name : str
    parameters : tuple of Parameter
        Its own; a declared parameter of the same name is replaced (an inertia set free, say).
    starts : tuple of tuple of float
        Values of `parameters` from which fits begin.
    family : str
        Forms of one effect share a family (one harmonic, two harmonics): rivals in form only.
    acts_on : str
        ``friction``, ``actuator``, ``load`` or ``sensor``.
    coordinates : tuple of str
        On which the residual depends where the effect is missing: ``balance:coordinate``, e.g.
        ``friction:speed``, ``load:position`` (names as in `identification.tracing.coordinates`).
    echoes : tuple of str
        Where its lack shows as well, without being its own: a wrong breakaway moves the residual
        of what follows it.  Opens a round to it, and excuses nothing that is left.
    experiment : str
        One line: the experiment that reveals it.
    least : float
        Least relative fall of the held-out error that is asked of it, where that is more than of
        others: of one that is the best of hundreds (wavelengths, say).
    blurred : float
        Part by which its error is higher than it would be if its runs began as surely as others':
        worse by so much excludes it in no one's place.
    again : float
        With a ``number`` below this it is named only where it leaves no more than noise: a wave
        that does not come again is a form that much else is like.
    sizes : tuple of str
        Parameters that say how large the effect is; the others say of what shape.
    simpler : str
        Name of a simpler form: this one is tried only where that one promises something.
    further : bool
        Tried only where the best is of its family and leaves more than noise.
    plain : str
        Name of the same effect with one size for all, or without what else it contains: lists
        name that one only.
    contains : tuple of str
        Candidates of which this is a generalization: no rival of theirs, it does all they do.
    yields_to : str
        One of those that is named in its place if it does as well with as many numbers: of runs
        that do not tell the two apart it says less.
    declared : bool
        No effect, but a declared value far off: what is known to its tolerance is no rival of an
        effect that acts on the same and does better.
    fitted : tuple of (str, float)
        Values of all parameters, declared ones too, with which an earlier search left it: where one
        more fit begins.
    at : tuple of str
        Places (``clutch 4``) where alone it was found to act; () of one that acts everywhere.
    """

    name: str
    parameters: tuple[Parameter, ...]
    starts: tuple[tuple[float, ...], ...]
    family: str
    acts_on: str
    coordinates: tuple[str, ...]
    experiment: str = ""
    least: float = field(default=-np.inf, kw_only=True)
    blurred: float = field(default=0.0, kw_only=True)
    again: float = field(default=0.0, kw_only=True)
    sizes: tuple[str, ...] = field(default=(), kw_only=True)
    simpler: str = field(default="", kw_only=True)
    further: bool = field(default=False, kw_only=True)
    plain: str = field(default="", kw_only=True)
    contains: tuple[str, ...] = field(default=(), kw_only=True)
    yields_to: str = field(default="", kw_only=True)
    echoes: tuple[str, ...] = field(default=(), kw_only=True)
    declared: bool = field(default=False, kw_only=True)
    fitted: tuple[tuple[str, float], ...] = field(default=(), kw_only=True)
    at: tuple[str, ...] = field(default=(), kw_only=True)

    def has_of(self, label: str, simpler: Candidate) -> bool:
        """Whether its numbers ``label.field`` are of the effect that a simpler candidate adds."""
        return True

    @property
    def frees(self) -> bool:
        """Whether it adds nothing, and sets declared numbers free."""
        return False

    @property
    def places(self) -> tuple[str, ...]:
        """Labels of places (clutches, joints) each of which has numbers of its own."""
        return ()

    def only(self, places: Collection[str]) -> Candidate:
        """This candidate acting at `places` alone, some of its own."""
        return self

    @property
    def listed(self) -> bool:
        """Whether lists of effects hold it: not what is another one in a further form."""
        return not (self.plain or self.further)

    @property
    def listed_as(self) -> str:
        """The name by which lists of effects know it."""
        return self.simpler.partition(" by ")[0] if self.further else self.plain or self.name


class Predictor(Protocol):
    """A model of the rig that replays recorded runs; deterministic, no hidden state."""

    parameters: tuple[Parameter, ...]

    def predict(
        self, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[np.ndarray]]:
        """Channel -> one array (samples,) for each replay, at the recorded time stamps [SI].

        Beside the observed channels: ``breakaway_torque`` (what the clutch could hold at that
        instant; read at observed breakaways), and whatever coordinates the model knows that the
        record does not (``excitation``). A model that fails returns arrays of NaN, never raises.
        """
        ...

    def simulated(
        self, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[np.ndarray]]:
        """As `predict`, but every run begins as it says, also where its start is free."""
        ...

    def extended(self, candidate: Candidate) -> Predictor:
        """This model with one more effect."""
        ...

    def combines(self, candidate: Candidate) -> bool:
        """Whether the effect goes together with those that the model has."""
        ...
