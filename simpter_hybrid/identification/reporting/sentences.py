"""What a diagnosis says, in sentences."""

from __future__ import annotations

from math import prod
from typing import Any

from ..false_alarms import FalseAlarms
from ..fitting.fitted_model import Trial
from ..fitting.predictor import Candidate
from ..result import Diagnosis
from ..run_levels import differs
from ..tracing.locating import LEAST_RINGING
from ..tracing.named import OF_BOTH, coordinate_of, left_in_both
from ..tracing.ringing import RINGING, line
from ..tracing.slow_state import RUN
from ..tracing.verdict import GROWING, LACKING
from .dependence_text import as_well, depends_on, hardly_left_text, is_straight
from .held_out_sentences import held_out, held_out_text, most_carried_over
from .lack_sentences import FAR_BELOW, FAR_BELOW_TEXT, lack_sentence, noise_left_text
from .level_sentences import levels_text
from .meaning import INCOMPLETE, LIKE_A_BEARING, OR_NOISE, meaning
from .other_ways import other_way

#: Family of what changes all that drives an axis by one factor.
DRIVE_GAIN = "drive gain"
#: Beyond so many times the floor what is still missing may be what an effect stands for: a drag and
#: a dead time of a driver were two wrong drags at 132 times.
GUESSED = 10.0


def verdict_sentence(found: Diagnosis) -> str:
    """The sentence a reader wants first; and what differs from run to run, if anything does."""
    where = found.search.verdict.coordinates
    if not found.levels or not all(map(differs, found.levels)):
        return _sentence(found)
    told = levels_text(found.levels, found.search.floor)
    if found.search.verdict.kind != "unknown" or found.taken_back is not None:
        return f"{_sentence(found)} Beside that {told}."
    others = [c for c in where if coordinate_of(c) != RUN]
    rest = f" What is left depends on {depends_on(others, is_straight(found))}." if others else ""
    return f"{told[0].upper()}{told[1:]}. No effect of the library does that.{rest}"


def _sentence(found: Diagnosis) -> str:
    kind = found.search.verdict.kind
    return lack_sentence(found) if kind in ("nothing missing", *LACKING) else _of_effects(found)


def _of_effects(found: Diagnosis) -> str:
    ratio = found.search.corrected.select_error / found.search.floor
    if max(ratio, held_out(found)) <= GUESSED:
        return _named(found)
    one = len(found.search.corrected.effects) == 1
    behind = "that name" if one else "these names"
    return f"{_named(found)} So much is left that what is still missing may stand behind {behind}."


def _named(found: Diagnosis) -> str:
    verdict, effects = found.search.verdict, found.search.corrected.effects
    ratio, held = found.search.corrected.select_error / found.search.floor, held_out_text(found)
    values = found.search.corrected.values
    named = (
        f"{e.name}{_at(e)}{other_way(found, e.name, values)}{_or_form(found, e.name)}"
        f"{_or_all(found, e)}"
        for e in effects
    )
    text = " and ".join(named) or "an effect"
    below = max(ratio, held_out(found)) < FAR_BELOW
    whose = "its form" if len(effects) == 1 else "a form"
    doubted, far = doubts(found), FAR_BELOW_TEXT if below else ""
    noise = noise_left_text(found)
    on = depends_on(verdict.coordinates, is_straight(found))
    if verdict.kind == "cannot be told apart" and doubted:
        left = f", which depends on {on}" if verdict.coordinates else ""
        more = f": more is left{left} (on those that select {ratio:.2f})."
        others = [c for c in verdict.coordinates if c not in verdict.as_well]
        little = hardly_left_text(found, on, held_out(found)) if others else ""
        more = f"{more}{noise}" if ratio > found.limits.form else f".{little}"
        return f"These data point to {text}, but {'; '.join(doubted)}. It leaves {held}{more}{far}"
    if ratio <= found.limits.form and held_out(found) > most_carried_over(found):
        left = f" What is left depends on {on}." if verdict.coordinates else ""
        return (
            f"The model lacks {text}; with it the error is {ratio:.2f} times the floor on the runs "
            f"that select, but {held}: these show more that is missing, or {whose} is another one."
            f"{left}"
        )
    if verdict.kind == "form incomplete" or ratio > found.limits.form:
        whose += OR_NOISE if noise else INCOMPLETE
        if ratio <= found.limits.form and verdict.coordinates:
            return (
                f"The model lacks {text}; with it the error is {held} ({ratio:.2f} times on those "
                f"that select). What is left still depends on {on}: {whose}.{noise}{far}"
            )
        left = f"; what is left depends on {on}" if verdict.coordinates else ""
        stays = "stays at" if ratio > found.limits.form else "is"
        return (
            f"The model lacks {text}; {whose} (the error {stays} {ratio:.2f} "
            f"times the floor on the runs that select, {held}){left}.{noise}"
        )
    rest = hardly_left_text(found, on, held_out(found)) if verdict.coordinates else ""
    return f"The model lacks {text}; with it the error is {held}.{rest}{far}"


def _at(effect: Candidate) -> str:
    """Words that say of which clutches or joints alone an effect was found; "" if of all."""
    *others, last = effect.at or ("",)
    return f" (of {', '.join(others)}{' and ' if others else ''}{last} alone)" if last else ""


def _or_form(found: Diagnosis, name: str) -> str:
    near = [_tried(found, t) for t in found.forms.get(name, ())]
    return f" (or, of the same kind, {', '.join(near)})" if near else ""


def _tried(found: Diagnosis, trial: Trial) -> str:
    """Name of what else would do, with what it does there."""
    name = trial.candidate.name
    return name + other_way(found, name, trial.fit.values)


def _or_all(found: Diagnosis, effect: Candidate) -> str:
    """Words on what no motion tells from a gain of the sensor of an axis's drive; else ""."""
    if effect.family != DRIVE_GAIN or effect.acts_on != "sensor":
        return ""
    times = 1.0 + found.search.corrected.values[effect.parameters[0].name]
    return (
        f" (or inertia, friction and whatever else acts, all {times:.3g} times as large as in the "
        "corrected model: no motion tells these apart)"
    )


def forms_of(found: Diagnosis, name: str) -> list[str]:
    """Other forms of an effect that do as well: which of them is a matter of words."""
    return [t.candidate.name for t in found.forms.get(name, ())]


def doubts(found: Diagnosis) -> list[str]:
    """Sentences on what the data do not exclude in place of each effect that was added."""
    effects = found.search.corrected.effects
    names, families = {e.name for e in effects}, {e.family for e in effects}
    said, known = [], set[str]()
    for verdict in (r.verdict for r in found.search.rounds):
        best = verdict.accepted.candidate if verdict.accepted is not None else None
        if best is None or best.name not in names:
            continue
        # A rival that a later round has added is no rival any more.
        others = [t for t in verdict.rivals if t.candidate.family not in families]
        if others:
            also = ", ".join(_tried(found, t) + _how_far_off(found, t) for t in others)
            said.append(f"do not exclude {also} in place of {best.name}")
        if verdict.as_well:
            known |= {*verdict.as_well}
            said.append(
                f"{as_well(verdict.as_well, is_straight(found))} would do as well as {best.name}"
            )
    if beside := [c for c in found.search.verdict.as_well if c not in known]:
        every = " and ".join(sorted(names))
        said.append(f"{as_well(beside, is_straight(found))} would do about as well as {every}")
    return said


def _how_far_off(found: Diagnosis, trial: Trial) -> str:
    """Words on how many times as declared a number far off would be; "" of an effect."""
    candidate: Any = trial.candidate
    own = {name for name, _ in getattr(candidate, "shares", ())}
    if not candidate.declared or len(own) != 1:
        return ""
    values, declared = trial.fit.values, found.search.refitted.predictor.declared  # type: ignore[attr-defined]
    times = {
        (1.0 + values[name]) * prod(
            values[t["name"]]
            for t in declared.notes.get("tolerances", ())
            if number in t["parameters"] and t["name"] in values
        )
        for name, number in candidate.shares
    }  # fmt: skip
    said = dict.fromkeys(f"{x:.3g}" for x in sorted(times))
    return f" ({' and '.join(said)} times as declared)"


def rings_sentence(found: Diagnosis) -> str:
    """Sentence on the frequency at which what is left rings after breakaways; "" without one."""
    rounds = found.search.rounds
    left = rounds[-1].after.get(RINGING, ()) if rounds else ()
    heard = [d for d in left if d.gain >= LEAST_RINGING]
    if not heard:
        return ""
    frequency, times = line(heard[0])
    return (
        f"After breakaways what is left rings at about {frequency:.0f} Hz: over its spectrum "
        f"elsewhere in the runs it stands out there {times:.0f} times as far as at most of them."
    )


def trials_sentence(trials: FalseAlarms | None) -> str:
    """Sentence on how far the search can be trusted on these runs; "" if that was not asked."""
    if trials is None:
        return ""
    told = ", ".join(f"{name} {times}" for name, times in trials.named.items())
    named = f"{sum(trials.named.values())} times{f' ({told})' if told else ''}"
    cut = f" ({trials.cut_short} of them were cut short: `--effort`)" if trials.cut_short else ""
    untold = (
        f", and said {trials.untold} times that it cannot be told whether something is missing"
        if trials.untold else ""
    )  # fmt: skip
    return (
        f"In {trials.count} synthetic sets of these runs in which nothing more is missing{cut} the "
        f"same search, weights not chosen anew and without what follows it (runs that differ, "
        f"curves, runs held out), named an effect {named} and told of a lack that none explains "
        f"{trials.unknown} times{untold}."
    )


def class_sentence(found: Diagnosis) -> str:
    """Sentence on the class of what was found: friction, actuator, load or sensor."""
    effects = found.search.corrected.effects
    if not effects:
        return ""
    force = "force" if is_straight(found) else "torque"
    ports = (f"{e.name}{meaning(e).replace('torque', force)}: {e.acts_on}" for e in effects)
    return f"Kind of what was found: {', '.join(ports)}."


def or_sensor_sentence(found: Diagnosis) -> str:
    """That one torque alone tells no friction that changes in a run from its sensor; else ""."""
    grown = [
        e.name for e in found.search.corrected.effects
        if e.acts_on == "friction" and e.coordinates
        and {coordinate_of(c) for c in e.coordinates} <= {*GROWING}
    ]  # fmt: skip
    if told := _left_in_both(found) or _or_bearing(found):
        return told
    if not grown:
        return ""
    before = found.search.rounds[0].before
    if not before.get(OF_BOTH[0]) or before.get(OF_BOTH[1]):
        return ""
    return (
        f"One torque alone does not tell {' and '.join(grown)} from a sensor whose gain changes "
        "alike: log the motor's torque as well."
    )


def _left_in_both(found: Diagnosis) -> str:
    """That what an effect of the clutch leaves in the drive's balance is the sensor's; else ""."""
    left = found.search.verdict.coordinates
    for e in found.search.corrected.effects:
        if own := left_in_both(e.acts_on, e.coordinates, left):
            along = " and ".join(name.replace("_", " ") for name in sorted(own))
            return (
                f"What is left goes along with {along} in what the motor gives and the clutch is "
                f"read to take as well, which {e.name} does not change: does {along} reach the "
                f"torque's sensor? Then it, and not {e.name}, may be all there is."
            )
    return ""


def _or_bearing(found: Diagnosis) -> str:
    """That a bearing beside the clutch looks like a gain of its sensor or the motor's; else ""."""
    model = found.search.corrected
    # Without the motor's torque no record shows what a bearing takes from it.
    if not all(found.search.rounds[0].before.get(balance) for balance in OF_BOTH):
        return ""
    for name in (e.name for e in model.effects if e.name in LIKE_A_BEARING):
        if (size := LIKE_A_BEARING[name] * model.values[f"{name}.gain"]) > 0.0:
            return (
                f"A bearing beside the clutch that rubs in proportion to the clutch's torque (by "
                f"{100 * size:.2g} % of it) would look the same as {name}: no run of this rig "
                "tells these apart, a known torque on the sensor does."
            )
    return ""


def at_limit_sentence(found: Diagnosis) -> str:
    """Sentence on sizes that ended at the limit of what is looked for; "" if none did."""
    model: Any = found.search.corrected
    ended = [
        p.name
        for effect in model.effects
        if not effect.ends_opened  # ends that are open all the time: there is no more of it
        for p in effect.parameters
        if p.name in effect.sizes and p.at_limit(model.values[p.name])
    ]
    if not ended:
        return ""
    return (
        f"{' and '.join(ended)} ended at the limit of what is looked for: more of it may be "
        "missing, or something else is."
    )
