"""A speed's sensor that is late by the record itself: no rival in its place."""

from __future__ import annotations

from dataclasses import replace

from .axis.signals import AxisSignals
from .axis.speed_sensor import FAMILY, behind_position, late_by
from .recordings.recording import Recording
from .tracing.limits import Limits
from .tracing.rounds import SearchResult

#: Lateness by the record and by a fit agree if they differ by less than this part: the record's is
#: that of straight movements, and a lag, a delay and a mean came to 12.8, 12.1 and 12.3 ms where it
#: said 13.  A speed made of differences is late by half a row, beside a drive that is late by more.
AGREE = 0.25


def named_by_record(done: SearchResult, recording: Recording, limit: Limits) -> SearchResult:
    """The search without rivals of a late speed that is as late beside its logged position.

    The two are of one motion, whatever drives it: an effect in place of the sensor's would leave
    unsaid why the speed is behind.  That the drive is late as well is not excluded by that, but by
    what a further round finds.

    Parameters
    ----------
    done : SearchResult
    recording : Recording
    limit : Limits
        Up to how many times the floor a form is right.
    """
    verdict, model = done.verdict, done.corrected
    first = verdict.accepted
    late = first is not None and first.candidate.family == FAMILY
    if not late or not verdict.rivals or verdict.as_well:
        return done
    position = recording.channels.get(AxisSignals.position)
    if position is None or position.summed:
        return done
    shown, fitted = behind_position(recording), late_by(model.values)
    if abs(shown - fitted) >= AGREE * fitted:
        return done
    kind = "form incomplete" if model.select_error > limit.form * done.floor else "effect"
    rounds = tuple(
        replace(r, verdict=replace(r.verdict, rivals=())) if r.verdict.accepted is first else r
        for r in done.rounds
    )
    return replace(done, rounds=rounds, verdict=replace(verdict, kind=kind, rivals=()))
