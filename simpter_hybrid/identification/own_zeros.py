"""A force sensor whose zero is another in each run: what a balance is off by, run by run.

A load cell that was set up anew, or warmed between runs.  No effect of a model does that, and what
it leaves goes along with whatever else differs between runs.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from .axis.motor import motor_of
from .axis.prescribed_replays import PrescribedSignals
from .axis.prescribed_rig import PrescribedRig
from .axis.rig import AxisRig
from .map_changes import OwnZeros
from .recordings.recording import Recording
from .rigs.bench import Bench
from .tracing.trace import Trace

#: Balance of an axis; the sensors of what drives it.
BALANCE, DRIVES = "force", ("force", "torque")
#: Part of a run's samples that each direction of motion has: one way friction is a zero as well.
BOTH_WAYS = 0.15
#: Rows that are not compared make a mean too small, by less each time it is taken off.
PASSES = 3
#: Zeros are apart by this part of their usual size; else they are one, which is an effect.
APART = 0.5


def own_zeros(
    bench: Bench, recording: Recording, values: Mapping[str, float]
) -> OwnZeros | None:  # fmt: skip
    """What the sensor of an axis's force would have to be off by in each run; None if it is none.

    Of the runs that fit and select, by what the balance with the refitted `values` leaves of them.
    """
    sensor = _sensor(bench, recording)
    if sensor is None:
        return None
    channel, each = sensor
    found = OwnZeros((channel,), ())
    for _ in range(PASSES):
        known = dict(found.zeros)
        left = _left_in_runs(bench, found.made(recording), values)
        if len(left) < 2 or not np.isfinite([*left.values()]).all():
            return None
        more = {run: known.get(run, 0.0) + each * off for run, off in left.items()}
        found = OwnZeros((channel,), tuple(more.items()))
    zeros = np.array([zero for _, zero in found.zeros])
    alike = np.ptp(zeros) <= APART * abs(float(np.median(zeros)))
    known_runs = {run.name for run in recording.runs}
    return None if alike or not dict(found.zeros).keys() <= known_runs else found


def _left_in_runs(
    bench: Bench, recording: Recording, values: Mapping[str, float]
) -> dict[str, float]:
    """Run -> mean of what its balance leaves; NaN of one that goes one way."""
    predictor: Any = bench.predictor
    runs = [run for part in ("fit", "select") for run in bench.made(recording, part)]
    traces = bench.tracer(runs)(predictor, values, runs).get(BALANCE, [])
    return {run.name: _off(trace) for run, trace in zip(runs, traces, strict=False)}


def _sensor(bench: Bench, recording: Recording) -> tuple[str, float] | None:
    """Channel of a sensed force, and what it shows for each unit of force that is missing."""
    rig, channels = bench.predictor.rig, recording.channels
    if isinstance(rig, PrescribedRig):
        return PrescribedSignals().force, 1.0
    if not isinstance(rig, AxisRig) or not rig.sensed:
        return None
    shown = next((n for n in DRIVES if n in channels and channels[n].role == "input"), None)
    return None if shown is None else (shown, -1.0 / motor_of(bench.predictor.declared)[1])


def _off(trace: Trace) -> float:
    """Mean of a balance's residual over both ways; NaN of a run that goes one way."""
    compared = trace.residual != 0.0  # what is not has none
    ways = trace.coordinates["direction"][compared]
    both = [trace.residual[compared][ways == way] for way in (1.0, -1.0)]
    if min(part.size for part in both) <= BOTH_WAYS * ways.size:
        return np.nan
    return 0.5 * sum(float(np.mean(part)) for part in both)
