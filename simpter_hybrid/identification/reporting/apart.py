"""A position and a speed of one thing that do not go together: which of them is to be believed?"""

from __future__ import annotations

from collections.abc import Sequence

from ..doubted_channels import Doubt
from ..recordings.agreement import unequal_gains
from ..recordings.recording import Recording
from ..recordings.speed_zero import IN_ALL
from ..rotor.signals import RotorSignals

#: Part by which a position may change by more or less than its speed says without a question ahead
#: of the verdict.
APART = 0.1


def apart_sentence(recording: Recording, doubts: Sequence[Doubt]) -> str:
    """Sentence on a speed that is, in every run, far more or less than the rate of its position.

    A clock that is wrong by that factor looks the same, and what inertia and friction it makes no
    effect mends.  "" where a `Doubt` asks about that channel already.  Of a rotor also on one that
    is off by the same all the time, and is taken without that.
    """
    return " ".join(filter(None, (_zeros_off(recording), _by_factors(recording, doubts))))


def _zeros_off(recording: Recording) -> str:
    if RotorSignals.transmitted not in recording.channels:
        return ""  # there the search itself tells a sensor's zero from what drives
    told = [
        f"{f.what[0].upper()}{f.what[1:]} ({f.value}): is the zero of its sensor off? What follows "
        f"takes that off, as `{f.right.split('`')[1]}` in the map does."
        for f in recording.findings
        if f.what.endswith(IN_ALL)
    ]
    return " ".join(told)


def _by_factors(recording: Recording, doubts: Sequence[Doubt]) -> str:
    asked = {name for doubt in doubts for name in doubt.change.channels}
    runs = [(run.time, run.channels) for run in recording.runs]
    said = [
        f"{position.replace('_', ' ')} changes by {factor:.3g} times what "
        f"{speed.replace('_', ' ')} says, in every run"
        for speed, position, factor in unequal_gains(runs, recording.channels)
        if abs(factor - 1.0) > APART and not asked & {speed, position}
    ]
    if not said:
        return ""
    told = "; ".join(said)
    return (
        f"{told[0].upper()}{told[1:]}: is the gain of one of them wrong, or the clock? What "
        "follows takes stamps and channels as they are."
    )
