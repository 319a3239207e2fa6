"""What is said of a speed that is compared and comes late, or may."""

from __future__ import annotations

from collections.abc import Sequence

from ..axis.speed_sensor import FAMILY
from ..recordings.agreement import lateness
from ..recordings.off_axis import off_axis
from ..recordings.recording import Recording
from ..result import Diagnosis
from ..tracing.verdict import LACKING, Verdict


def of_late_speed(found: Diagnosis, recording: Recording) -> str:
    """`late_speed_sentence` of a diagnosis: a late speed that was found and is all says nothing."""
    done = found.search
    late = any(e.family == FAMILY for e in done.corrected.effects)
    left = done.corrected.select_error > found.limits.form * done.floor
    others = [e.name for e in done.corrected.effects if e.family != FAMILY]
    named = () if late and not left else others
    return late_speed_sentence(recording, done.verdict, named, late and left)


def late_speed_sentence(
    recording: Recording, verdict: Verdict, named: Sequence[str] = (), found: bool = False
) -> str:
    """Sentence that the speed which is compared is late, or may be in a way of its own.

    A position beside it shows that it is: then whatever is `named` or lacking may be that.  Of a
    speed alone it cannot be known; it is asked where nothing that was tried explains what an axis
    lacks, or a lateness was `found` that leaves more.
    """
    channels = recording.channels
    compared = "speed" in channels and channels["speed"].role == "measured"
    lacking = verdict.kind in LACKING
    if not (compared and (found or lacking or named)):
        return ""
    if "position" in channels:
        known = [(run.time, run.channels) for run in recording.runs]
        late = lateness(known, channels).get("speed", ("", 0.0))[1]
        if late <= 0.0:
            return ""
        what = "what is left may be that"
        if named:
            what = f"{' and '.join(named)} may be that, or make up for it"
        advice = (
            "Leave the speed out of the map; the position tells as much, if its sensor is right."
        )
        if any(off_axis(recording.runs, channels)):
            advice = (
                "First put the wave once a turn right that the position beside it shows: without "
                "the speed nothing tells it from what the model lacks. Then leave the speed out."
            )
        return (
            "The speed, which is compared, is behind the position logged beside it "
            f"(by {1e3 * late:.3g} ms): {what}. {advice}"
        )
    if not (found or lacking) or not any(c.role == "input" for c in channels.values()):
        return ""
    return (
        "Only a speed was logged: one that is late otherwise than by one lag, delay or average "
        "leaves what looks like nothing known. Log the position as well: beside it a late speed is "
        "told."
    )
