"""What the refitted and the corrected model say of the held-out runs, computed once."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .fitting.fitted_model import Model
from .fitting.replay import Observation, Replay
from .fitting.residual import CLIP, deviation
from .recordings.noise import channel_noise, run_noise
from .recordings.recording import Recording
from .result import Diagnosis
from .rigs.free_start import Predicted, started


@dataclass(frozen=True)
class Telling:
    """Run, channel and sample of the largest change."""

    run: int
    channel: str
    sample: int


@dataclass(frozen=True)
class HeldOutPredictions:
    """Held-out runs with both predictions; the run that tells most is drawn.

    Parameters
    ----------
    replays : sequence of Replay
    before, after : mapping of str to sequence of ndarray (samples,)
        Channel -> prediction of every run [SI], by the refitted and by the corrected model.
    corrected : Model
    telling : Telling or None
        None: nothing is compared in these runs.
    declared : mapping, optional
        As `before`, by the model as declared; None unless the refitted one errs more than that.
    """

    replays: Sequence[Replay]
    before: Predicted
    after: Predicted
    corrected: Model
    telling: Telling | None
    declared: Predicted | None = None

    @property
    def stages(self) -> dict[str, Predicted]:
        """Both predictions by the names that a report has for them."""
        return {"refitted": self.before, "after": self.after}

    @property
    def changed(self) -> bool:
        """Whether the corrected model is another one than the refitted."""
        pairs = (
            (b, a) for c in self.after for b, a in zip(self.before[c], self.after[c], strict=True)
        )
        return any(not np.array_equal(b, a, equal_nan=True) for b, a in pairs)


def held_out_predictions(found: Diagnosis) -> HeldOutPredictions:
    """Both models on the runs that had no part in finding anything."""
    done, replays = found.search, found.split.report

    def told(model: Model) -> Predicted:
        simulate = model.predictor.simulated
        return simulate(model.values, started(simulate, model.values, replays))

    before, after = told(done.refitted), told(done.corrected)
    declared, errors = None, found.error_by_stage
    if errors["declared"] < errors["refitted"]:
        nominal = {p.name: p.value for p in done.refitted.predictor.parameters}
        declared = told(replace(done.refitted, values=nominal))
    telling = most_telling(replays, before, after)
    return HeldOutPredictions(replays, before, after, done.corrected, telling, declared)


def most_telling(replays: Sequence[Replay], before: Predicted, after: Predicted) -> Telling | None:
    """Run and channel whose error the correction lowers most, and the row that it changes most.

    Where nothing was found to correct, where the error is largest.
    """
    asked = [(i, channel) for i, replay in enumerate(replays) for channel in replay.observed]

    def square(predicted: Predicted, i: int, channel: str) -> float:
        seen = replays[i].observed[channel]
        left = deviation(seen, predicted[channel][i], weighed=False) / seen.sd
        left = np.where(np.isfinite(left), np.clip(left, -CLIP, CLIP), CLIP)  # as in a fit
        return float(np.mean(left**2)) if left.size else 0.0

    if not asked:
        return None
    falls = [square(before, *at) - square(after, *at) for at in asked]
    changed = any(falls)
    if not changed:
        falls = [square(after, *at) for at in asked]
    i, channel = asked[int(np.argmax(falls))]
    other = before[channel][i] if changed else replays[i].observed[channel].values
    apart = np.abs(np.nan_to_num(after[channel][i] - other))
    kept = np.where(replays[i].observed[channel].keep, apart, 0.0)
    return Telling(i, channel, int(np.argmax(kept if kept.any() else apart)))


def noise_of(
    recording: Recording | None, channel: str, seen: Observation, time: np.ndarray
) -> float:
    """Standard deviation of a channel's noise in a run [SI].

    The deviation by which residuals count may be much larger: where nothing is repeated it holds
    what the declared model leaves, and of a tester's force what its motion's noise does.  A run
    may be noisier than half of all, whose noise `channel_noise` is.
    """
    if recording is None or channel not in recording.channels:
        return seen.sd * seen.own
    here = run_noise(seen.values, recording.channels[channel], time)
    return min(seen.sd * seen.own, max(here, channel_noise(recording, channel)))
