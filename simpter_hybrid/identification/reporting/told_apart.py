"""Which runs count as repeated, and whether their records or only a model tells them apart."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ..axis.signals import AxisSignals
from ..fitting.repeats import STRETCH, repeated_floor, repetitions
from ..fitting.replay import Replay
from ..recordings.noise import noise_in
from ..recordings.recorded_run import RecordedRun
from ..recordings.recording import Recording
from ..result import Diagnosis

#: Repetitions that differ by more than so many times the noise are asked about (those of a cart
#: under a random force of 0.6 of its friction did by 2.5); most listed.
FAR_APART, LISTED = 2.0, 3
#: Records of two runs are alike if in no stretch a signal differs by more than so many times its
#: noise: of fifty rows white noise does by 1.3 at most, and estimates of it are off by a tenth.
ALIKE = 1.5


def repeated_sentence(
    repeated: Sequence[Sequence[str]],
    over_noise: float,
    alike: Sequence[Sequence[str]] = (),
    turns: bool = False,
) -> str:
    """Sentence on which runs count as repeated, where they differ far more than by noise.

    `alike`: those that only the model tells apart.  `turns`: whether something may come once a
    turn, which a sensor that counts from each start on does not tell.
    """
    if over_noise <= FAR_APART:
        return ""
    said = (
        f"The floor is what runs of one course differ by ({listed(repeated)}): {over_noise:.1f} "
        "times the noise known otherwise."
    )
    others = "them"
    if alike:
        said += (
            f" The records of {listed(alike)} differ by no more than their sensors' noise: it is "
            "the model that tells them apart (it may stick in one and move on in the other). Where "
            "it lacks something, that lack is in this floor, and errors in times the floor say too "
            "little."
        )
        others = "the others"
    if len(alike) == len(repeated):
        return said
    angle = ", or the runs began at another angle of something that comes once a turn"
    return (
        f"{said} If something else was not the same in {others} (another device, a load)"
        f"{angle if turns else ''}, log it as a `constant` of each run: then they count as no "
        "repetition."
    )


def listed(repeated: Sequence[Sequence[str]]) -> str:
    """Names of the runs of each group, of as many groups as a sentence bears."""
    listed = "; ".join(" and ".join(names) for names in repeated[:LISTED])
    more = f"; and {len(repeated) - LISTED} more" if len(repeated) > LISTED else ""
    return f"{listed}{more}"


def told_apart_by_the_model(
    found: Diagnosis, recording: Recording
) -> tuple[tuple[str, ...], ...]:  # fmt: skip
    """Names of repeated runs of which the records are alike, and what the model leaves is not."""
    if found.over_noise <= FAR_APART:
        return ()
    model, noise = found.search.corrected, found.floors.select / found.over_noise
    runs = {run.name: run for run in recording.runs}
    groups = repetitions([*found.fitted, *found.split.select])
    return tuple(
        tuple(run.name for run in group)
        for group in groups
        if _records_alike(group, runs, recording)
        and repeated_floor(model.predictor, model.values, [group])[0] > FAR_APART * noise
    )


def _records_alike(
    group: Sequence[Replay], runs: dict[str, RecordedRun], recording: Recording
) -> bool:  # fmt: skip
    """Whether no signal of these runs differs from that of the first by more than its noise."""
    first, *others = (runs.get(replay.name) for replay in group)
    if first is None or None in others:  # pieces of runs
        return False
    return all(
        name in run.channels and _signals_alike(first, run, recording, name)
        for run in others
        if run is not None
        for name in first.channels
    )


def _signals_alike(a: RecordedRun, b: RecordedRun, recording: Recording, name: str) -> bool:
    """Whether a signal of two runs is the same but for noise, stretch by stretch.

    Of what a driver was told noise is none, unless the map states it.
    """
    channel = recording.channels[name]
    sensed = channel.role == "measured" or name.startswith((*AxisSignals().sensed,))
    noise = 0.0
    if sensed or channel.noise is not None:
        noise = max(noise_in(run, recording, name) for run in (a, b))
    rows = min(a.time.size, b.time.size)
    apart = (a.channels[name][:rows] - b.channels[name][:rows]) / np.sqrt(2.0)
    known = np.nan_to_num(apart)
    ends = np.searchsorted(a.time, np.arange(a.time[0], a.time[-1], STRETCH))
    stretches = (s for s in np.split(known, ends[ends < rows]) if s.size)
    return all(np.sqrt(np.mean(s**2)) <= ALIKE * noise for s in stretches)
