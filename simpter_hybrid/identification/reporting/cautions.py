"""What a reader should ask before a verdict: of the data, of the map."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

import numpy as np

from ..axis.seen_drive import BY_IT
from ..doubted_channels import Doubt
from ..far_off import FarOff
from ..fitting.effort import USUAL
from ..percent import percent
from ..recordings.checks import Finding
from ..recordings.motion import Motion
from ..recordings.recording import Recording
from ..ruling_run import RulingRun
from ..tracing.rounds import SearchResult
from ..tracing.verdict import LACKING, Verdict

#: Endings of the remarks on a channel that stays at its extremes.
CUT_OFF = ("cut off?", "clipped?")
#: A held input that changes at so many rows of a run may well change between them, too.
AT_MOST_ROWS = 0.5
#: ... unless it goes on as it did: two changes that differ by no more than this part of the larger.
ON_COURSE = 0.25
#: Words that say of all effects what holds of those that were tried, and their verbs.
NONE = (
    ("none of the known effects", "explains it", "were"),
    ("no effect of the library", "does that", "was"),
)


def in_view_of(
    still: Mapping[str, Motion], sentence: str, doubts: Sequence[Doubt] = (),
    cut_short: float = 0.0, unfitted: int = 0, off: FarOff | None = None, *, of: float = np.inf,
) -> str:  # fmt: skip
    """A verdict's sentence, with a caution before it.

    Where data hardly move, a map or a declared number is doubted, or the search did not come to
    its end.
    """
    if cut_short:
        sentence = f"As far as the search went: {sentence[0].lower()}{sentence[1:]}"
        sentence = _of_tried(sentence, unfitted, of) if unfitted else sentence
    if doubts or off:
        right = "the map is right" if doubts else "the declared numbers are right"
        right += " and so are the declared numbers" * any(d.numbers for d in doubts)
        sentence = f"If {right}: {sentence[0].lower()}{sentence[1:]}"
    if not still:
        return sentence
    said = ", ".join(f"{name} {motion}" for name, motion in still.items())
    return (
        f"These data hardly move ({said}) and show little. As far as they show, "
        f"{sentence[0].lower()}{sentence[1:]}"
    )


def _of_tried(sentence: str, unfitted: int, of: float) -> str:
    """A sentence that says of what was tried what it says of all effects."""
    for known, does, verb in NONE:
        if unfitted >= of:
            sentence = re.sub(rf"\. {known} {does}", ". No effect was fitted", sentence, flags=re.I)
            sentence = re.sub(f"{known} {does}", "no effect was fitted", sentence, flags=re.I)
        tried = rf"\1 that {verb} tried ({unfitted} were not)"
        sentence = re.sub(f"({known})", tried, sentence, flags=re.I)
    return sentence


def far_off_sentence(off: FarOff | None, inverse: str = "") -> str:
    """Sentence on declared numbers that may be farther off than their tolerances say.

    `inverse`: what does the same of an axis that nothing drives.
    """
    if off is None:
        return ""
    others = "".join(
        f"{', or' if one is off.others[0] else ' or'} with {one.name} {one.times:.3g} times as "
        f"declared {percent(one.left)}"
        for one in off.others
    )
    than = "farther off than its tolerance says" if off.known else "far off"
    return (
        f"Is a declared number {than}? With "
        f"{off.name} {off.times:.3g} times as declared {percent(off.left)} of the refitted "
        f"model's error is left{others}."
        + f" Nothing drives the axis, so only ratios of its forces to its inertia are known: "
        f"{inverse}, with the rest refitted, would look alike." * bool(inverse)
    )


def ruling_run_sentence(ruling: RulingRun | None) -> str:
    """Sentence on a fitted run that may be unlike the others."""
    if ruling is None:
        return ""
    return (
        f"Did something else act in {ruling.name} alone (a hand, a stop)? Refitted without it the "
        f"declared model leaves {percent(ruling.left)} of its error on the runs that select."
    )


def passed_over_sentence(done: SearchResult) -> str:
    """Sentence on the way that a search had gone before, with another first effect."""
    if done.passed_over is None or not done.corrected.effects:
        return ""
    ended, first = done.passed_over.corrected, done.corrected.effects[0]
    best = done.passed_over.rounds[0].best
    named = {e.name for e in done.corrected.effects}
    if not ended.effects and best is not None and best.candidate.name not in named:
        return (
            f"Begun with {best.candidate.listed_as} nothing could be named; begun with "
            f"{first.listed_as} it ends at {done.corrected.select_error / done.floor:.3g} times "
            "the floor on the runs that select."
        )
    if not ended.effects or ended.select_error <= done.corrected.select_error:
        return ""
    instead, *further = (e.listed_as for e in ended.effects)
    beside = f"with {' and '.join(further)}" if further else "and nothing helped"
    alone = {t.candidate.name: t.select_error for t in done.rounds[0].trials}
    less = alone.get(ended.effects[0].name, np.inf) < alone.get(first.name, 0.0)
    return (
        f"Begun with {instead}{f', which alone leaves less than {first.listed_as} does,' * less} "
        f"the search ended at {ended.select_error / done.floor:.3g} times the floor on the runs "
        f"that select, {beside} beside it; here it ends at "
        f"{done.corrected.select_error / done.floor:.3g}."
    )


def cut_short_sentence(
    steps: float, unfitted: int, interrupted: bool = False, unfinished: bool = False
) -> str:
    """Sentence that a search did not come to its end; "" if it did.

    `unfinished`: what follows is of the passes before the last one.
    """
    if not steps:
        return ""
    how = "interrupted" if interrupted else "cut short"
    after = f"The search was {how} after {steps / 1e6:.3g} million steps of simulated runs"
    left = (
        f"{after}, with {unfitted} candidates not fitted in its last pass: what follows is what "
        "had been found by then"
    )
    if unfinished:
        left = (
            f"{after}: its last pass was not finished and is not used; what follows is what had "
            "been found before it"
        )
    longer = f"; `--effort {3.0 * steps / USUAL:.2g}` goes on for three times as long"
    return left + ("" if interrupted else longer) + "."


def cut_off_sentence(findings: Sequence[Finding]) -> str:
    """Sentence on which channels look as if they were cut off; "" if none does."""
    # The name of a channel may have blanks in it.
    cut = (f.what.partition(" stays at ") for f in findings if f.what.endswith(CUT_OFF))
    names = dict.fromkeys(name for name, *_ in cut)
    if not names:
        return ""
    return (
        f"Is a sensor cut off ({', '.join(names)})? The remarks on the recording say where it "
        "stays at its extreme; a force or a speed is not compared at `limits` that the map states."
    )


def driver_sentence(findings: Sequence[Finding]) -> str:
    """Sentence on a driver that a sensor shows to be another than declared; "" if none does."""
    told = [
        f"{f.what.split()[0]} {f.value.removeprefix(BY_IT)}"
        for f in findings
        if f.value.startswith(BY_IT)
    ]
    if not told:
        return ""
    return (
        f"The driver, or its sensor, is not as declared: by the measured "
        f"{', and by the '.join(told)}. Declare it so, or let the sensor's channel drive (the "
        "remarks on the recording say how)."
    )


def between_rows_sentence(recording: Recording, verdict: Verdict) -> str:
    """Sentence that a drive may have changed unseen, where no effect explains what is left.

    Nulls of which every second or third drive of a servo was logged are "unknown".  Commands of a
    clutch are those of a plan.
    """
    if verdict.kind not in LACKING:
        return ""
    held = [
        name
        for name, channel in recording.channels.items()
        if channel.role == "input" and channel.held != "sampled" and not _command(name)
    ]
    changes = {name: _changes(recording, name) for name in held}
    often = {name: part for name, part in changes.items() if part > AT_MOST_ROWS}
    if not often:
        return ""
    told = ", ".join(f"{name} at {100 * part:.0f} %" for name, part in often.items())
    return (
        f"What is held until the next row changes at most rows of a run ({told}): if it is set "
        "more often than rows come, what it did between them is missing here and would look like "
        "a lack that no effect explains. Then log it as often as it is set."
    )


def no_place_sentence(recording: Recording, verdict: Verdict) -> str:
    """Sentence that no position was logged, where nothing that was explains what an axis lacks."""
    names = recording.channels.keys()
    placed = "position" in names or "speed" not in names
    if placed or verdict.kind not in LACKING or verdict.coordinates:
        return ""
    return (
        "No place was logged: what depends on one (an imbalance, a wave of friction, a patch) "
        "would look so. Log the position as well, or sum up the speed from a place that is known "
        "and give both."
    )


def _command(name: str) -> bool:
    return name.startswith("command")


def _changes(recording: Recording, name: str) -> float:
    """Part of its changes after which another follows, in the run where that is most.

    Not where the next is nearly the same: what is on its course at the rows (a ramp, a slow wave of
    a reference) is so between them.
    """
    parts = [0.0]
    for run in recording.runs:
        if name in run.channels:
            change = np.diff(run.channels[name])
            now, then = np.abs(change[:-1]), np.abs(change[1:])
            known = np.isfinite(now) & np.isfinite(then)
            same = np.abs(np.diff(change)) <= ON_COURSE * np.maximum(now, then)
            parts.append(float(np.mean((now > 0.0) & ~same & known)) if same.size else 0.0)
    return max(parts)
