"""Residual traces of a rotor with one clutch: the two torque balances along every run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from ..fitting.predictor import Predictor
from ..fitting.replay import Replay
from ..recordings.row_step import row_step
from ..recordings.smoothing import moving_mean
from ..tracing.balance import rotor_balance
from ..tracing.coordinates import coordinates, since_rest, since_turn
from ..tracing.locating import VIBRATION
from ..tracing.logged import told_apart
from ..tracing.named import REVERSAL
from ..tracing.ringing import RINGING, ringing_trace
from ..tracing.trace import BLOCK, Trace
from .signals import RotorSignals

#: Residuals beyond this many standard deviations are instants, not dependences.
BOUND = 12.0
#: A way back of this many standard deviations of the position is no noise, even of a long rest.
TURNS = 10.0
#: A torque that rises by less than this part of the level of breakaway in a second stands still.
SLOWEST = 1e-3
#: Steps of a command's converter come again and again over its range: 12 bins average them out.
LOCAL = ("excitation",)


@dataclass(frozen=True)
class RotorTracer:
    """Makes the traces of a rig with one rotor, one driving torque and one clutch.

    Parameters
    ----------
    inertia : float
        Declared inertia of the rotor [kg*m^2].
    sd : float
        Noise of the transmitted torque [N*m].
    signals : RotorSignals
        Channels as predicted (the position as recorded in the replay's notes).  What `command`
        leads the excitation by is the coordinate ``drive``; `prescribed` is the applied torque in
        runs whose applied torque is not a measured channel.
    excitation : str
        Predicted channel.
    others : tuple of str
        Inputs that are coordinates as they are, e.g. a neighbour's command.
    position_noise : float
        Standard deviation of the position [rad].
    turn : float
        Period of the position [rad]; inf of a rotor that stays within a turn.
    """

    inertia: float
    sd: float
    signals: RotorSignals = RotorSignals()
    excitation: str = "excitation"
    others: tuple[str, ...] = ("neighbour_command",)
    position_noise: float = 0.0
    turn: float = 2 * np.pi

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Balance -> traces.

        ``friction`` (sensor), ``load`` (rotor), ``breakaway`` (levels), ``vibration`` (how much
        the friction residual spreads from sample to sample, less its mean), ``ringing`` (spectra
        of the friction residual after breakaways).
        """
        predicted = predictor.predict(values, replays)
        levels = [
            breakaway_trace(r, holds)
            for r, holds in zip(replays, predicted["breakaway_torque"], strict=True)
            if len(r.breakaways) > 2
        ]
        resolved = TURNS * self.position_noise
        found: dict[str, list[Trace]] = {"friction": [], "load": [], VIBRATION: [], RINGING: []}
        for i, replay in enumerate(replays):
            torque = predicted[self.signals.transmitted][i]
            # What a run that failed does not tell has no residual here; its error is the worst.
            speed, carried, excitation = (
                np.nan_to_num(predicted[c][i])
                for c in (self.signals.speed, self.signals.transmitted, self.excitation)
            )
            along = self._along(replay, speed, carried, excitation)
            step = row_step(replay.time)
            samples = max(1, round(BLOCK / step))
            friction = self._friction(replay, torque)
            load = self._load(replay, {c: p[i] for c, p in predicted.items()})
            for balance, residual in (("friction", friction), ("load", load)):
                begins, logged = {REVERSAL: resolved}, told_apart(replay.logged, along)
                trace = Trace(residual, carried, along, False, begins, LOCAL, logged)
                found[balance].append(trace.thinned(samples))
            shaken = along | {"since_rest": since_rest(replay.time, speed)}
            spread = Trace(self._spread(friction, samples, replay.replicates), carried, shaken)
            found[VIBRATION].append(spread.thinned(samples))
            starts = [b.index for b in replay.breakaways]
            if (rings := ringing_trace(friction, step, starts)) is not None:
                found[RINGING].append(rings)
        found[VIBRATION] = _centred(found[VIBRATION])
        return {**found, "breakaway": levels} if levels else found

    def _along(
        self, replay: Replay, speed: np.ndarray, carried: np.ndarray, excitation: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Coordinates of a run, by its position as recorded and what is predicted of it."""
        position = replay.notes[self.signals.position]
        more = {
            "drive": replay.inputs[self.signals.command] - excitation,
            REVERSAL: since_turn(position, TURNS * self.position_noise),
            **{name: replay.inputs[name] for name in self.others},
        }
        return coordinates(replay.time, position, speed, carried, excitation, more, self.turn)

    def _friction(self, replay: Replay, torque: np.ndarray) -> np.ndarray:
        seen = replay.observed[self.signals.transmitted]
        return self._bounded(np.where(seen.keep, seen.values - torque, 0.0))

    def _spread(self, friction: np.ndarray, samples: int, replicates: int) -> np.ndarray:
        """Square of what changes within a block, over that of noise (of a mean of runs)."""
        if samples == 1:
            return np.zeros(friction.size)
        smooth = moving_mean(friction, samples)
        variance = self.sd**2 / replicates * (1.0 - 1.0 / samples)
        square = (friction - smooth) ** 2 / variance
        return np.minimum(square, BOUND)

    def _load(self, replay: Replay, predicted: Mapping[str, np.ndarray]) -> np.ndarray:
        """What the drive gives and the clutch does not take.

        Where a servo drives, the difference of the two residuals: friction errors pass through the
        servo into both and cancel, and so does what the sampling of the servo's torque aliases.
        Where a torque drives, the measured balance less the predicted one.
        """
        seen = replay.observed[self.signals.transmitted]
        drive = replay.observed.get(self.signals.applied)
        if drive is not None:
            taken = seen.values - predicted[self.signals.transmitted]
            given = drive.values - predicted[self.signals.applied]
            return self._bounded(np.where(seen.keep, given - taken, 0.0))
        if (
            self.signals.speed not in replay.observed
        ):  # a servo drove it and its torque was not recorded
            return np.zeros(replay.time.size)
        applied = replay.inputs[self.signals.prescribed]
        speed = replay.observed[self.signals.speed].values
        measured = rotor_balance(replay.time, speed, applied, seen.values, self.inertia, self.sd)
        told = rotor_balance(
            replay.time,
            predicted[self.signals.speed],
            applied,
            predicted[self.signals.transmitted],
            self.inertia,
            self.sd,
        )
        return self._bounded(np.where((measured == 0.0) | (told == 0.0), 0.0, measured - told))

    def _bounded(self, residual: np.ndarray) -> np.ndarray:
        finite = np.where(np.isfinite(residual), residual, 0.0)
        return np.clip(finite, -BOUND * self.sd, BOUND * self.sd)


def breakaway_trace(replay: Replay, holds: np.ndarray) -> Trace:
    """Relative errors of a run's breakaway levels against what they may depend on.

    ``rest`` (logarithm of the time at rest), ``direction``, ``level`` (predicted), ``same_way``
    (1 after a slip in the same direction, 0 after one in the other, 0.5 for a run's first),
    ``slips_before``, their number in the run, and ``load_rate`` (logarithm of how fast the torque
    rose).
    """
    events = [b for b in replay.breakaways if np.isfinite(holds[max(b.index - 1, 0)])]
    level = np.array([abs(b.level) for b in events])
    predicted = np.array([holds[max(b.index - 1, 0)] for b in events])
    way = np.array([np.sign(b.level) for b in events])
    along = {
        "rest": np.log10([max(b.rested, 1e-3) for b in events]),
        "direction": way,
        "level": predicted,
        "same_way": np.concatenate([[0.5], way[1:] == way[:-1]])[: way.size],
        "slips_before": np.arange(way.size, dtype=float),
        "load_rate": np.log10([max(b.rises, SLOWEST * abs(b.level)) for b in events]),
    }
    relative = level / np.maximum(predicted, 1e-9) - 1.0
    return Trace(relative, np.zeros(level.size), along, events=True)


def _centred(traces: Sequence[Trace]) -> list[Trace]:
    """Traces less their common mean: noise of another size, or colour, is no dependence."""
    if not any(t.residual.size for t in traces):
        return list(traces)
    mean = float(np.mean(np.concatenate([t.residual for t in traces])))
    return [replace(t, residual=t.residual - mean) for t in traces]
