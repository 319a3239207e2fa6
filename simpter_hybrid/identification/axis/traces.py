"""Residual force of one axis along every run, by inverse dynamics."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.integrate import cumulative_trapezoid

from ..fitting.predictor import Predictor
from ..fitting.replay import Replay, Restart
from ..recordings.row_step import row_step
from ..recordings.smoothing import derivative, speed_width, whole
from ..tracing.coordinates import carried_on, coordinates
from ..tracing.logged import told_apart
from ..tracing.trace import PLACE, Trace, force_trace
from .drive_force import Motor, force_by
from .replays import as_if_recorded
from .speed_sensor import SHOWN

#: Length of the kernel by which the error of the speed is differentiated [s].
WIDTH = 0.06
#: The recorded acceleration is taken over so many times `WIDTH`: a 64th of its noise is left.
WIDER = 4
#: A run is followed where the prediction of its whole is off by less than this part of its motion.
FOLLOWS = 0.1
#: Names that the inertia of an axis may have as a parameter of its device.
HEAVY = ("inertia", "mass")


@dataclass(frozen=True)
class AxisTracer:
    """Makes the traces of a driven axis: the one balance ``force``.

    Parameters
    ----------
    inertia : float
        Declared [kg m^2 or kg].
    turn : float
        Period of the position [rad]; inf for a straight axis, 0 of a place that nobody knows.
    drawn : bool
        Whether what drives is a set point, or the end of a spring: a place and no force.  Friction
        as predicted is then what the force along the axis is known by.
    drifts : bool
        Whether nothing drives any run and nothing depends on the place: the acceleration is then
        what friction does, and no cause of it.
    pressed : bool
        Whether what presses is not the same all through the fitted runs: else friction has no
        excitation.
    motors : tuple of ForceDrive or VoltageDrive
        Declared; they make the force of the recorded drive.
    """

    inertia: float
    turn: float = np.inf
    drawn: bool = False
    drifts: bool = False
    pressed: bool = False
    motors: tuple[Motor, ...] = ()

    def __call__(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Traces of the missing force: inertia times the error of the acceleration."""
        # Not a servo's own loop: set anew it would have lost what its integral holds.
        whole = replays
        replays = [
            r
            if r.inputs["drive"].any()
            else replace(r, restarts=r.restarts or r.followed, start_free=False)
            for r in replays
        ]
        predicted = predictor.predict(values, replays)
        by_record = self._by_record(predictor, values, whole, replays)
        found, local = [], PLACE if self.turn else ()
        for i, replay in enumerate(replays):
            step = row_step(replay.time)
            missing = self._missing(replay, predicted, i) - by_record.get(i, 0.0)
            force = self._force(replay, predicted, i)
            along = self._along(replay, predicted["excitation"][i], force)
            logged = told_apart(replay.logged, along)
            found.append(force_trace(missing, force, along, step, logged=logged, local=local))
        return {"force": found}

    def forces(
        self, predictor: Predictor, values: Mapping[str, float], replays: Sequence[Replay]
    ) -> dict[str, list[Trace]]:
        """Force of the model itself in every row at the recorded motion, as if it were missing.

        It is minus inertia times acceleration.  Models with and without an effect then differ by
        the effect's force alone, not by what became of the motion before; what the record tells
        does not enter.
        """
        set_anew = [_set_at_every_row(r) for r in replays]
        predicted = predictor.predict(values, set_anew)
        found = []
        for i, replay in enumerate(set_anew):
            lacks = -self._inertia(replay) * np.nan_to_num(predicted["acceleration"][i])
            force = self._force(replay, predicted, i)
            found.append(
                Trace(lacks, force, self._along(replay, predicted["excitation"][i], force))
            )
        return {"force": found}

    def _inertia(self, replay: Replay) -> float:
        """Inertia of the axis in one run: the declared one and what is known to be added in it."""
        return self.inertia + sum(replay.added.get(f"device.{name}", 0.0) for name in HEAVY)

    def _force(
        self, replay: Replay, predicted: Mapping[str, Sequence[np.ndarray]], i: int
    ) -> np.ndarray:
        """Force along the axis that passes its friction (samples,)."""
        if self.drawn:
            return np.nan_to_num(predicted["friction"][i])
        drive, released = replay.inputs["drive"], replay.inputs["released"]
        return force_by(self.motors, drive, released, replay.notes["speed"])

    def _along(
        self, replay: Replay, excitation: np.ndarray, force: np.ndarray
    ) -> dict[str, np.ndarray]:
        """Coordinates on which a residual may depend, all (samples,)."""
        step = row_step(replay.time)
        # Not the predicted one: it holds the force's noise and, where a servo makes up for what is
        # missing, that too.  The record's noise is in what is missing as well, but for this kernel.
        recorded = derivative(replay.notes["speed"], step, WIDER * max(WIDTH, 9 * step))
        along = coordinates(
            replay.time,
            replay.notes["position"],
            replay.notes["speed"],
            force,
            np.nan_to_num(excitation),
            {"acceleration": recorded},
            turn=self.turn,
            since=self._before(replay),
        )
        if not self.pressed:
            along = {n: x for n, x in along.items() if not n.startswith("excitation")}
        if self.drifts:
            along.pop("acceleration")
            along["direction"] = gone(along["direction"])
        return along

    def _before(self, replay: Replay) -> tuple[float, float, float] | None:
        """Time, way and heat of the pieces before this one of the same run."""
        if replay.before is None:
            return None
        first = replay.before.led_in
        drive, released = first.inputs["drive"], first.inputs["released"]
        speed = first.notes["speed"]
        passed = force_by(self.motors, drive, released, speed)
        return carried_on(first.time, speed, 0.0 * speed if self.drawn else passed)

    def _missing(
        self, replay: Replay, predicted: Mapping[str, Sequence[np.ndarray]], i: int
    ) -> np.ndarray:
        """Inertia times the error of the acceleration (samples,)."""
        step = row_step(replay.time)
        rises = predicted.get(SHOWN, predicted["acceleration"])[i] * step
        told = unbroken(predicted["speed"][i], rises, [r.index for r in replay.restarts])
        if "speed" not in replay.observed:  # then the record's was derived from positions
            course = cumulative_trapezoid(told, dx=step, initial=0.0)
            told = derivative(course, step, speed_width(step))
        width = max(WIDTH, 9 * step)
        lacks = derivative(replay.notes["speed"] - told, step, width)
        if SHOWN in predicted and "speed" in replay.observed:
            # How fast it was where a run begins, a late speed hardly tells: no row before is known.
            lacks[: int(np.argmax(replay.observed["speed"].keep)) + whole(width / step)] = 0.0
        return self._inertia(replay) * lacks

    def _by_record(
        self, predictor: Predictor, values: Mapping[str, float], whole: Sequence[Replay],
        replays: Sequence[Replay],
    ) -> dict[int, np.ndarray]:  # fmt: skip
        """Missing force that reading a record alone would feign, of the model's own motion.

        A polynomial cuts the tops of a fast oscillation: the force of a spring seemed wrong in
        proportion to where the mass was.  Only of runs let alone that the model follows to their
        end.
        """
        asked = [i for i, r in enumerate(whole) if r.followed and not r.inputs["drive"].any()]
        moved = predictor.predict(values, [whole[i] for i in asked]) if asked else {}
        made: dict[int, Replay] = {}
        for n, i in enumerate(asked):
            course = np.nan_to_num(moved["position"][n])
            seen = replays[i].notes["position"]
            if np.std(seen - course) < FOLLOWS * np.std(seen):
                made[i] = as_if_recorded(replays[i], course, np.nan_to_num(moved["speed"][n]))
        again = predictor.predict(values, list(made.values())) if made else {}
        return {i: self._missing(made[i], again, n) for n, i in enumerate(made)}


def gone(direction: np.ndarray) -> np.ndarray:
    """Directions (samples,) that go on through rest, before the first motion that of this.

    Where nothing drives an axis nothing shows at rest what is missing: a coast-down that ended
    there was told to lack something that depends on direction, of which it had only one.
    """
    moves = np.flatnonzero(direction)
    if not moves.size:
        return direction
    last = np.searchsorted(moves, np.arange(direction.size), side="right") - 1
    return direction[moves[np.maximum(last, 0)]]


def _set_at_every_row(replay: Replay) -> Replay:
    """The run with its motion set from the record wherever that tells it."""
    q, v = replay.notes["position"], replay.notes["speed"]
    told = np.flatnonzero(np.isfinite(q) & np.isfinite(v))
    restarts = tuple(Restart(int(k), float(q[k]), float(v[k])) for k in told[told > 0])
    return replace(replay, restarts=restarts, start_free=False)


def unbroken(speed: np.ndarray, rises: np.ndarray, set_anew: Sequence[int]) -> np.ndarray:
    """A predicted speed (samples,) without the jumps where it was set from the record.

    There `rises`, what it rises in each sample by its own acceleration, stand for the jump.
    """
    steps = np.diff(np.nan_to_num(speed), prepend=0.0)
    for k in set_anew:
        steps[k : k + 2] = np.nan_to_num(rises[k : k + 2])
    return np.cumsum(steps)
