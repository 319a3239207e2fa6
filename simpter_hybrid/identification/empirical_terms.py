"""Curves that may be fitted over the variable on which an unexplained residual depends."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from ..effect import Effect
from ..effects.empirical_channel import EmpiricalByChannel
from ..effects.empirical_force import EmpiricalDrag, EmpiricalForce, EmpiricalForceByAngle
from ..effects.empirical_friction import (
    EmpiricalByAngle,
    EmpiricalByExcitation,
    EmpiricalByPosition,
    EmpiricalBySlip,
    EmpiricalBySpeed,
    Knots,
)
from ..effects.empirical_history import (
    EmpiricalByDistance,
    EmpiricalByHeat,
    EmpiricalByReversal,
    EmpiricalByTime,
)
from .fitting.predictor import Parameter
from .rigs.effect_candidate import EffectCandidate
from .tracing.coordinates import HEAT_MEMORY
from .tracing.curve import stretch
from .tracing.locating import VIBRATION
from .tracing.logged import AS_LOGGED
from .tracing.named import balance_of, coordinate_of
from .tracing.ringing import RINGING
from .tracing.slow_state import RUN
from .tracing.trace import Trace

#: A position is taken for an angle that comes again if it covers more than this part of a turn:
#: what turns does, a slide of a few decimetres does not.
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
#: Coordinate of a trace -> the one whose values a curve over it goes by: friction knows nothing of
#: what is passed on but by what presses, nor of a direction but by a slip.
GOES_BY: Mapping[str, str] = {"torque": "excitation", "direction": "slip_velocity"}
#: Curves that come again after each turn: after their last knot comes the first.
IN_TURN = (EmpiricalByAngle, EmpiricalForceByAngle)
#: Balances of a device with one friction surface.
OF_ONE = ("friction", "force")
#: A knot is expected within this of no change (a relative change of friction), so that it stays
#: near none where there are no data.
EXPECTED = 0.5
#: Ends of a curve: this part of the recorded samples lies beyond each.
TAIL = 0.002
#: Where nine tenths of the samples lie within half of that, a curve over these alone is tried as
#: well: its knots are where the data are (of speeds up to 31 rad/s most were below 3).
MOST, NARROW = 0.05, 0.5
#: A curve is at least as wide as this part of all the values.
LEAST = 1e-6
#: A curve over a whole travel has seven knots.  What happens at one place (a catch, a bump, a step)
#: is looked for by curves over pieces of this part of it, each begun half a piece farther on.
PIECE = 0.25
#: What a curve acts on, in words.
WORDS = {"clutch": "clutch", "coordinate": "joint"}


def terms_over(
    coordinate: str, traces: Mapping[str, Sequence[Trace]]
) -> tuple[EffectCandidate, ...]:
    """Candidates over one coordinate of a trace: friction, force, or either; none for the rest."""
    balance, name = balance_of(coordinate), coordinate_of(coordinate)
    if not traces.get(balance) or balance in (VIBRATION, RINGING, "breakaway") or name == RUN:
        return ()
    if name in traces[balance][0].logged:
        if balance not in OF_ONE:
            return ()
        values = np.concatenate([t.logged[name] for t in traces[balance]])
        return (over_channel(name.removesuffix(AS_LOGGED), values),)
    along = _values(traces[balance], name)
    if along.size == 0 or not np.ptp(along) > 0.0:
        return ()
    size = _usual(traces[balance])
    joint = int(balance.removeprefix("joint_")) - 1 if balance.startswith("joint_") else 0
    numbered = re.fullmatch(r"(slip|excitation)_(\d+)", name)
    clutch = int(numbered[2]) - 1 if numbered else joint
    name = numbered[1] if numbered else name
    turns = name == "position" and _folded(along)
    over_position = EmpiricalByAngle if turns else EmpiricalByPosition
    found: list[tuple[type[Effect] | None, Mapping[str, int], float]] = []
    # On a device with several clutches only their own slips and excitations tell one from another.
    if balance in OF_ONE or numbered:
        curve = over_position if name == "position" else FRICTION.get(name)
        found.append((curve, {"clutch": clutch}, EXPECTED))
    if balance != "friction" and not numbered and size > 0.0:
        unit = size if name == "position" else size / float(np.abs(along).max())
        curve = EmpiricalForceByAngle if turns else FORCE.get(name)
        found.append((curve, {"coordinate": joint}, unit))
    local = stretch(traces[balance], name) if name in traces[balance][0].local else None
    return tuple(
        _candidate(cls, place, ends, expected)
        for cls, place, expected in found
        if cls is not None
        for ends in _ends(cls, along, local)
    )


def pieces_of(
    coordinate: str, traces: Mapping[str, Sequence[Trace]]
) -> tuple[EffectCandidate, ...]:
    """Curves over pieces of a way to and fro, of one friction surface; none over all else."""
    balance, name = balance_of(coordinate), coordinate_of(coordinate)
    if balance != "force" or name != "position" or not traces.get(balance):
        return ()
    along = np.concatenate([t.coordinates[name] for t in traces[balance]])
    if _folded(along):
        return ()
    size = _usual(traces[balance])
    low, high = (float(q) for q in np.quantile(along, (TAIL, 1.0 - TAIL)))
    wide = PIECE * (high - low)
    begin = [low + 0.5 * wide * k for k in range(round(2.0 / PIECE) - 1)] if wide > 0.0 else []
    kinds = (
        (EmpiricalByPosition(clutch=0), -0.9, EXPECTED),
        (EmpiricalForce(coordinate=0), -10.0 * size, size),
    )
    return tuple(
        _fitted_knots(
            replace(effect, low=a, high=a + wide),
            f"{_kind(effect)} from {a:.3g} to {a + wide:.3g}", lowest, expected,
        )
        for effect, lowest, expected in kinds
        if expected > 0.0
        for a in begin
    )  # fmt: skip


def goes_by(coordinate: str) -> str:
    """What a curve over a coordinate goes by: ``force:direction`` is ``force:slip_velocity``."""
    balance, name = balance_of(coordinate), coordinate_of(coordinate)
    return f"{balance}:{GOES_BY[name]}" if name in GOES_BY else coordinate


def _values(traces: Sequence[Trace], name: str) -> np.ndarray:
    """Values of what a curve over a coordinate goes by (samples,); none where no trace has it."""
    asked, along = GOES_BY.get(name, name), traces[0].coordinates
    if asked not in along:
        return np.zeros(0)
    values = np.concatenate([t.coordinates[asked] for t in traces])
    signs = bool(re.fullmatch(r"slip_\d+", name)) and bool(np.isin(values, (-1, 0, 1)).all())
    if not signs or "slip_velocity" not in along or not np.ptp(values) > 0.0:
        return values
    # Of a clutch among several only the sign of its slip is told: it slips as fast as the joint
    # on which it shows, one way or the other.
    speed = np.concatenate([t.coordinates["slip_velocity"] for t in traces])
    return np.concatenate([speed, -speed])


def _usual(traces: Sequence[Trace]) -> float:
    """The usual size of a force: of what passes the surface or, where nothing does, of the lack.

    0 if nothing is missing either.
    """
    passed, lack = (
        np.abs(np.concatenate(forces))
        for forces in ([t.torque for t in traces], [t.residual for t in traces])
    )
    sizes = (float(np.median(passed)), float(np.median(lack)), float(np.max(lack)))
    return next((size for size in sizes if size > 0.0), 0.0)


def over_channel(channel: str, values: np.ndarray) -> EffectCandidate:
    """A curve of friction over a logged channel, of its recorded values (samples,) [SI]."""
    low, high = (float(q) for q in np.quantile(values, (TAIL, 1.0 - TAIL)))
    span = float(np.ptp(values)) or abs(low) or 1.0  # of a constant channel nothing tells a span
    decimals = 6 - math.floor(math.log10(span))
    effect = EmpiricalByChannel(
        clutch=0, low=low, high=_above(low, high, span), channel=channel,
        points=((0.0, round(float(np.mean(values)), decimals)),),
    )  # fmt: skip
    return _fitted_knots(effect, f"{_kind(effect)} {channel}", -0.9, EXPECTED)


def _folded(along: np.ndarray) -> bool:
    """Whether positions are angles that come again: all around, and never beyond one turn."""
    low, high = float(along.min()), float(along.max())
    return low >= 0.0 and high <= 2 * np.pi and high - low > ROUND * 2 * np.pi


def _ends(
    cls: type[Effect], along: np.ndarray, local: tuple[float, float] | None
) -> list[dict[str, float]]:
    """Ends of the curve, and what else its coordinate needs; several, where these are tried."""
    if cls in IN_TURN:
        return [{"low": 0.0, "high": 2 * np.pi}]
    if cls is EmpiricalDrag:
        return [{"high": float(np.abs(along).max())}]
    if cls is EmpiricalByReversal:
        far = float(np.quantile(along, 0.9))
        return [{"low": -1.0, "high": 1.0, "way": part * far} for part in (0.03, 0.2)]
    low, high = (float(q) for q in np.quantile(along, (TAIL, 1.0 - TAIL)))
    ends = [(low, _above(low, high, float(np.ptp(along))))]
    if local is not None:
        return [{"low": a, "high": b} for a, b in (local, *ends)]
    low, high = (float(q) for q in np.quantile(along, (MOST, 1.0 - MOST)))
    if 0.0 < high - low < NARROW * (ends[0][1] - ends[0][0]):
        ends.append((low, high))
    more = {"memory": HEAT_MEMORY} if cls is EmpiricalByHeat else {}
    return [{"low": a, "high": b} | more for a, b in ends]


def _above(low: float, high: float, span: float) -> float:
    """The high end, or one just above the low end where both are one."""
    return max(high, low + LEAST * span, float(np.nextafter(low, np.inf)))


def _candidate(
    cls: type[Effect], place: Mapping[str, int], ends: Mapping[str, float], expected: float
) -> EffectCandidate:
    effect = cls(**place, **ends)  # type: ignore[arg-type]
    lowest = -0.9 if issubclass(cls, Knots) else -10.0 * expected
    lowest = 0.0 if cls is EmpiricalDrag else lowest
    # A name is a curve's own: one of a name is tried, and there is one for each clutch and joint.
    (what, number), *_ = place.items()
    of = f" of {WORDS[what]} {number + 1}" if number else ""
    if "way" in ends:
        over = f"over {ends['way']:.3g}"
    else:
        over = f"from {ends.get('low', 0.0):.3g} to {ends['high']:.3g}"
    return _fitted_knots(effect, f"{_kind(effect)}{of} {over}", lowest, expected)


def _kind(effect: Effect) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "-", type(effect).__name__).lower()


def _fitted_knots(effect: Effect, name: str, lowest: float, expected: float) -> EffectCandidate:
    """The candidate whose knots are fitted, from none and expected to be none."""
    sizes = tuple(f"{name}.{size}" for size in effect.sizes)
    knots = tuple(
        Parameter(size, 0.0, lowest, 10.0 * expected, 0.1 * expected, expected) for size in sizes
    )
    return EffectCandidate(
        name, knots, ((0.0,) * len(knots),), _kind(effect), "empirical", (), effect.reveals, effect,
        sizes=sizes,
    )  # fmt: skip
