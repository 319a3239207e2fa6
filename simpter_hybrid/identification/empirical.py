"""An empirical term: a fitted curve over the variable on which an unexplained residual depends.

It can be simulated and lowers the error, but it is no law: it says how large a force is and not
why, and nothing beyond the range that was recorded.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from ..effect import Effect
from ..effects.empirical_force import EmpiricalDrag, EmpiricalForce
from ..effects.empirical_friction import (
    EmpiricalByAngle,
    EmpiricalByExcitation,
    EmpiricalByPosition,
    EmpiricalBySlip,
    EmpiricalBySpeed,
    between,
)
from ..effects.empirical_history import (
    EmpiricalByDistance,
    EmpiricalByHeat,
    EmpiricalByReversal,
    EmpiricalByTime,
)
from .fitting.fit import Fitter
from .fitting.fitted_model import Model, Split, Trial, with_effect
from .fitting.identifiability import estimates
from .fitting.predictor import Parameter
from .fitting.search import try_candidates
from .rigs.scenario_predictor import EffectCandidate
from .tracing.coordinates import HEAT_MEMORY
from .tracing.curve import stretch
from .tracing.locating import VIBRATION
from .tracing.ringing import RINGING
from .tracing.rivals import LEAST_GAIN
from .tracing.slow_state import RUN
from .tracing.trace import Trace

#: What turns is seen in more than this part of a turn; a slide of a few decimetres is not.
ROUND = 0.75
#: Coordinate of a trace -> curve that friction may follow.
FRICTION: Mapping[str, type[Effect]] = {
    "speed": EmpiricalBySpeed, "slip_velocity": EmpiricalBySlip, "direction": EmpiricalBySlip,
    "slip": EmpiricalBySlip, "excitation": EmpiricalByExcitation, "torque": EmpiricalByExcitation,
    "time": EmpiricalByTime, "distance": EmpiricalByDistance, "heat": EmpiricalByHeat,
    "displacement_since_reversal": EmpiricalByReversal,
}  # fmt: skip
#: ... and a force.
FORCE: Mapping[str, type[Effect]] = {
    "position": EmpiricalForce, "speed": EmpiricalDrag, "slip_velocity": EmpiricalDrag,
}  # fmt: skip
KNOTS = 7
#: How many ways after a reversal a curve over it is drawn to; three hundredths are left there.
WAYS = 3.5
#: A knot is expected within this of no change (relative change of friction): where there are no
#: data it stays there.
EXPECTED = 0.5
#: Coordinates that are tried, the strongest first.
TRIED = 4
#: Ends of a curve: this part of the recorded samples lies beyond each.
TAIL = 0.002
#: Where nine tenths of the samples lie within half of that, a curve over these alone is tried as
#: well: its knots are where the data are (of speeds up to 31 rad/s most were below 3).
MOST, NARROW = 0.05, 0.5


@dataclass(frozen=True)
class Empirical:
    """A curve that was added where no law is known.

    Parameters
    ----------
    coordinate : str
        ``balance:coordinate`` over which it is drawn.
    trial : Trial
        Its fit, with what it gains on the selecting runs.
    model : Model
        The corrected model with it.
    place, value, half_width : ndarray (knots,)
        Knots, fitted values and half-widths of their 95 % intervals [SI]; knots over the way since
        a reversal are those of `EmpiricalByReversal`, from -1 at it to 1 far from it.
    """

    coordinate: str
    trial: Trial
    model: Model
    place: np.ndarray
    value: np.ndarray
    half_width: np.ndarray

    def drawn(self, points: int = 241) -> tuple[np.ndarray, np.ndarray]:
        """Places and values of the curve as a simulation follows it, from end to end (points,)."""
        knots, turns = self.value, self.value.size < KNOTS
        if turns:  # after the last knot comes the first again
            every = [knots[-1], *knots, knots[0], knots[1]]
        else:
            every = [knots[1], *knots, knots[-2]]
        step = self.place[1] - self.place[0]
        where = np.linspace(0.0, KNOTS - 1.0, points)
        return self.place[0] + step * where, np.array([between(x, *every) for x in where])

    def recorded(self, place: np.ndarray) -> np.ndarray:
        """Places among the knots in the coordinate's own unit; far off is `WAYS` ways off."""
        effect = self.trial.candidate.effect  # type: ignore[attr-defined]
        if not isinstance(effect, EmpiricalByReversal):
            return place
        return effect.way * -np.log(np.maximum(0.5 * (1.0 - place), np.exp(-WAYS)))


def empirical_term(
    base: Model,
    coordinates: Sequence[str],
    traces: Mapping[str, Sequence[Trace]],
    split: Split,
    floor: float,
) -> Empirical | None:
    """The curve that lowers the held-out error most; None if none does by what is believed.

    Parameters
    ----------
    base : Model
        What has been found so far.
    coordinates : sequence of str
        ``balance:coordinate`` on which its residual depends, strongest first.
    traces : mapping of str to sequence of Trace
        Of the fitted runs; ranges and sizes are taken from them.
    split : Split
    floor : float
    """
    terms: dict[str, EffectCandidate] = {}
    where: dict[str, str] = {}
    for coordinate in coordinates:
        for term in terms_over(coordinate, traces):
            if term.name not in terms and len(terms) < TRIED:
                terms[term.name], where[term.name] = term, coordinate
    trials = try_candidates(base, list(terms.values()), split, floor)
    best = min(trials, key=lambda t: t.select, default=None)
    if best is None or best.gain < LEAST_GAIN:
        return None
    return curve_of(best, where[best.candidate.name], base, split)


def curve_of(best: Trial, coordinate: str, base: Model, split: Split) -> Empirical:
    """A trial of a curve as a term that can be drawn, with the intervals of its knots."""
    model = with_effect(base, best, split)
    fitter = Fitter(model.predictor, split.fit, unit=model.unit)
    rows, _ = estimates(model.predictor.parameters, fitter.fit(model.values, iterations=1))
    by_name = {r.name: r for r in rows}
    knots = best.candidate.sizes
    return Empirical(
        coordinate,
        best,
        model,
        _places(best.candidate),  # type: ignore[arg-type]
        np.array([model.values[k] for k in knots]),
        np.array([by_name[k].half_width for k in knots]),
    )


def _places(term: EffectCandidate) -> np.ndarray:
    effect = term.effect
    ends = getattr(effect, "low", 0.0), getattr(effect, "high", 1.0)
    return np.linspace(*ends, KNOTS)[: len(term.sizes)]


def terms_over(
    coordinate: str, traces: Mapping[str, Sequence[Trace]]
) -> tuple[EffectCandidate, ...]:
    """Candidates over one coordinate of a trace: friction, force, or either; none for the rest."""
    balance, _, name = coordinate.partition(":")
    if not traces.get(balance) or balance in (VIBRATION, RINGING, "breakaway") or name == RUN:
        return ()
    if name in traces[balance][0].logged:  # no model reads it
        return ()
    along = np.concatenate([t.coordinates[name] for t in traces[balance]])
    size = float(np.median(np.abs(np.concatenate([t.torque for t in traces[balance]]))))
    joint = int(balance.removeprefix("joint_")) - 1 if balance.startswith("joint_") else 0
    numbered = re.fullmatch(r"(slip|excitation)_(\d+)", name)
    clutch = int(numbered[2]) - 1 if numbered else joint
    name = numbered[1] if numbered else name
    turns = name == "position" and _folded(along)
    over_position = EmpiricalByAngle if turns else EmpiricalByPosition
    found: list[tuple[type[Effect] | None, Mapping[str, int], float]] = []
    # On a device with several clutches only their own slips and excitations tell one from another.
    if balance in ("friction", "force") or numbered:
        curve = over_position if name == "position" else FRICTION.get(name)
        found.append((curve, {"clutch": clutch}, EXPECTED))
    if balance != "friction" and not numbered:
        unit = size if name == "position" else size / max(float(np.abs(along).max()), 1e-9)
        found.append((FORCE.get(name), {"coordinate": joint}, max(unit, 1e-9)))
    local = stretch(traces[balance], name) if name in traces[balance][0].local else None
    return tuple(
        _candidate(cls, place, ends, expected)
        for cls, place, expected in found
        if cls is not None and float(np.ptp(along)) > 0.0
        for ends in _ends(cls, along, local)
    )


def _folded(along: np.ndarray) -> bool:
    """Whether positions are angles that come again: all around, and never beyond one turn."""
    low, high = float(along.min()), float(along.max())
    return low >= 0.0 and high <= 2 * np.pi and high - low > ROUND * 2 * np.pi


def _ends(
    cls: type[Effect], along: np.ndarray, local: tuple[float, float] | None
) -> list[dict[str, float]]:
    """Ends of the curve, and what else its coordinate needs; several, where these are tried."""
    if cls is EmpiricalByAngle:
        return [{"low": 0.0, "high": 2 * np.pi}]
    if cls is EmpiricalDrag:
        return [{"high": float(np.abs(along).max())}]
    if cls is EmpiricalByReversal:
        far = float(np.quantile(along, 0.9))
        return [{"low": -1.0, "high": 1.0, "way": part * far} for part in (0.03, 0.2)]
    low, high = (float(q) for q in np.quantile(along, (TAIL, 1.0 - TAIL)))
    ends = [(low, max(high, low + 1e-6))]
    if local is not None:
        return [{"low": a, "high": b} for a, b in (local, *ends)]
    low, high = (float(q) for q in np.quantile(along, (MOST, 1.0 - MOST)))
    if 0.0 < high - low < NARROW * (ends[0][1] - ends[0][0]):
        ends.append((low, high))
    more = {"memory": HEAT_MEMORY} if cls is EmpiricalByHeat else {}
    return [{"low": a, "high": b} | more for a, b in ends]


def _candidate(
    cls: type[Effect], place: Mapping[str, int], ends: Mapping[str, float], expected: float
) -> EffectCandidate:
    kind = re.sub(r"(?<=[a-z])(?=[A-Z])", "-", cls.__name__).lower()
    within = ends.get("way", ends["high"])
    name = f"{kind} within {within:.2g}"
    effect = cls(**place, **ends)  # type: ignore[arg-type]
    lowest = -0.9 if expected == EXPECTED else -10.0 * expected
    lowest = 0.0 if cls is EmpiricalDrag else lowest
    sizes = tuple(f"{name}.{size}" for size in effect.sizes)
    knots = tuple(
        Parameter(size, 0.0, lowest, 10.0 * expected, 0.1 * expected, expected) for size in sizes
    )
    start = (0.0,) * len(knots)
    return EffectCandidate(
        name, knots, (start,), kind, "empirical", (), effect.reveals, effect, sizes=sizes
    )
