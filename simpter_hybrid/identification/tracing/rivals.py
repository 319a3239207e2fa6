"""Which trials are believed, which of them is the best, and which it does not exclude."""

from __future__ import annotations

from collections.abc import Sequence

from ..fitting.fitted_model import Trial
from ..fitting.search import AT_FLOOR

#: Least relative fall of the held-out error for an effect to be accepted.
LEAST_GAIN = 0.02
#: ... or, of a first effect, least fall of the error of one experiment's runs: an effect that few
#: runs can show is diluted by all others.  Nulls gained 0.3 % so at most, effects that were missed
#: 9 to 15 % ...
LEAST_LOCAL = 0.05
#: ... if the error of all runs falls by this as well: nulls gained 0.0002.
LEAST_OF_ALL = 0.002
#: Least fall below a floor that is only estimated from single runs: of an own belt 2.0 % of nothing
#: was a Stribeck friction, and the least of right effects that own slides show there is 3.3 %.
LEAST_AT_ESTIMATE = 0.03
#: Least fall, of all runs together, where a model leaves this part of what repeated runs differ by,
#: or less: what they differ by, which no model knows, is patched by much.  Of a clutch whose
#: friction changed from run to run 0.4 % was a position-dependent friction, by one kind of run, at
#: 0.62 of the floor; right effects were found from 0.99 of it on.
LEAST_BELOW, BELOW = 0.03, 0.9
#: Least fall where a sensor saw the drive: its noise makes a model creep that rests, which a
#: friction that falls with speed mends (4.3 % of an own belt of which nothing was missing).
LEAST_IF_SENSED = 0.06
#: Least fall by a further effect.  What an imperfect form leaves can be patched by many effects:
#: that of right effects is 5 to 10 % above the floor, and most of it no single effect takes away.
LEAST_FURTHER = 0.05
#: A rival that explains at least this part of what the best explains may be the true one ...
RIVAL = 0.8
#: ... unless the best is at the floor (`AT_FLOOR`) and the rival worse by what is believed of an
#: effect (`LEAST_GAIN`): evidence between two effects is weighed as evidence for one ...
#: ... or leaves this many times the error that the best leaves near the floor (loop study: 20 %).
CLEARLY_WORSE = 1.2
#: ... or this many times it wherever the best ends: of a lack fifty times the floor almost any
#: candidate explains four fifths in mean squares.
FAR_WORSE = 2.0
#: An error after this many times the floor is off it.
OFF_FLOOR = 1.05
#: Errors this near each other are alike: the candidate with fewest parameters is named first.
TIE = 0.003
#: A richer form of the same effect, or one that contains it, must lower the error by this to be
#: preferred: a push on the tip was called a spring of next to no stiffness for 0.4 %.
RICHER_FORM = 0.01


def best_form(trials: Sequence[Trial]) -> Trial | None:
    """Best trial, or the simplest that is as good, or a simpler form that is nearly as good."""
    if not trials:
        return None
    first = min(trials, key=lambda t: t.select_error)
    # Where few runs show the effect, all of them dilute its gain, and so what counts as a tie.
    gained = min(1.0, max(first.gain, 0.0) / LEAST_GAIN)
    alike = [t for t in trials if t.select_error <= first.select_error * (1 + gained * TIE)]
    best = min(alike, key=lambda t: (len(t.candidate.parameters), t.select_error))
    simpler = best.candidate.contains
    forms = [
        t for t in trials
        if t.candidate.family == best.candidate.family or t.candidate.name in simpler
    ]  # fmt: skip
    near = [t for t in forms if t.select_error <= best.select_error * (1 + gained * RICHER_FORM)]
    best = min(near, key=lambda t: (len(t.candidate.parameters), t.select_error))
    plain = (t for t in near if t.candidate.name == best.candidate.yields_to)
    if (less := next(plain, None)) and less.select_error <= (1 + gained * TIE) * best.select_error:
        best = less
    return _before_declared(best, trials)


def _before_declared(best: Trial, trials: Sequence[Trial]) -> Trial:
    """A trial to be named in place of a declared value: one that ends alike and is a form of it.

    An effect is preferred to another declared value, which counts only if the best contains it.
    """
    if not best.candidate.declared:
        return best
    within = best.candidate.contains
    families = {t.candidate.family for t in trials if t.candidate.name in within}
    alike = [
        t for t in trials
        if t.select_error <= (1 + TIE) * best.select_error
        and t.candidate.family in families | {best.candidate.family}
        and len(t.candidate.parameters) <= len(best.candidate.parameters)
        and (not t.candidate.declared or t.candidate.name in within)
    ]  # fmt: skip
    return min(alike, key=lambda t: (t.candidate.declared, t.select_error), default=best)


def chosen(trials: Sequence[Trial], least: float = LEAST_GAIN) -> Trial | None:
    """The best form; if that is not believed, the best of those that are."""
    best = best_form(trials)
    if best is None or is_believed(best, least):
        return best
    return best_form([t for t in trials if is_believed(t, least)]) or best


def is_believed(trial: Trial, least: float = LEAST_GAIN) -> bool:
    """Whether a trial lowers the error of runs not seen by more than chance does.

    Where more than `LEAST_GAIN` is asked only the error of all runs counts.
    """
    least = max(least, trial.candidate.least)
    return trial.gain >= least or (least <= LEAST_GAIN and shows(trial.gain, trial.local))


def shows(gain: float, local: float) -> bool:
    """Whether all runs together, or those of one experiment, show an effect."""
    return gain >= LEAST_GAIN or (gain >= LEAST_OF_ALL and local >= LEAST_LOCAL)


def rivals_of(
    best: Trial, trials: Sequence[Trial], floor: float, vague: bool = False, part: float = RIVAL
) -> tuple[Trial, ...]:
    """Trials of other families that explain nearly as much, best of each family first.

    `part` is what they explain at least of what the best does.  A declared value that contains a
    form of the best is none of them; nor is one that an effect outdoes, unless this ends off the
    floor and another rival no better than the declared value.
    """
    found: dict[str, Trial] = {}
    second: list[Trial] = []
    forms = {t.candidate.name for t in trials if t.candidate.family == best.candidate.family}
    for trial in sorted(trials, key=lambda t: t.select_error):
        family = trial.candidate.family
        if family == best.candidate.family or not is_believed(trial):
            continue
        if best.candidate.name in trial.candidate.contains:
            continue
        if trial.candidate.declared and forms & set(trial.candidate.contains):
            continue
        error = trial.select_error / (1.0 + trial.candidate.blurred)
        worse = excluded(best.select_error, error, floor, vague)
        if _explained(trial) < part * _explained(best) or worse:
            continue
        if vague or not _outdone(trial, best):
            found.setdefault(family, trial)
        elif best.select_error > OFF_FLOOR * floor:
            second.append(trial)
    most = max((t.select_error for t in found.values()), default=0.0)
    for trial in second:
        if trial.select_error <= most:
            found.setdefault(trial.candidate.family, trial)
    return tuple(sorted(found.values(), key=lambda t: t.select_error))


def _outdone(trial: Trial, best: Trial) -> bool:
    """Whether an effect does better than a declared value that is far off, where both act."""
    one, other = trial.candidate, best.candidate
    alike = one.declared and not other.declared and one.acts_on == other.acts_on
    return alike and trial.select_error > (1 + TIE) * best.select_error


def other_forms(
    name: str, trials: Sequence[Trial], rivals: Sequence[Trial] = ()
) -> tuple[Trial, ...]:
    """Trials of other forms of an effect that end as near as one effect does to another.

    Where `rivals` of other families are not excluded, no form that ends nearer than these is. The
    best of each; what only has more or fewer numbers (a size for every clutch, one wave more,
    a gain for every pair) is no other form.
    """
    best = next((t for t in trials if t.candidate.name == name), None)
    if best is None:
        return ()
    near = max((r.select_error for r in rivals), default=0.0)
    found: dict[str, Trial] = {}
    for trial in sorted(trials, key=lambda t: t.select_error):
        if trial.candidate.family != best.candidate.family or nested(trial, best):
            continue
        if (
            abs(trial.select_error - best.select_error) <= LEAST_GAIN * best.select_error
            or trial.select_error <= near
        ):
            found.setdefault(_root(trial.candidate.name), trial)
    return tuple(found.values())


def nested(one: Trial, other: Trial) -> bool:
    """Whether one of two forms is the other with more numbers."""
    a, b = one.candidate, other.candidate
    simpler = _root(a.simpler), _root(b.simpler)
    related = _root(a.name) in (_root(b.name), simpler[1]) or _root(b.name) == simpler[0]
    return related or a.name in b.contains or b.name in a.contains


def _root(name: str) -> str:
    return name.partition(" by ")[0]


def _explained(trial: Trial) -> float:
    """Part of the whole mean square that a trial explains."""
    return 1.0 - (1.0 - trial.gain) ** 2


def excluded(best: float, rival: float, floor: float, vague: bool = False) -> bool:
    """Whether the errors of two models exclude the second.

    In one-way runs time, path and heat grow together, and a form that is not quite right costs
    more than what they differ by: there, and where what is left by the best tells that its form is
    not quite right, the small difference at the floor is too `vague`, and one below it is none.
    """
    near = max(best, floor) if vague else best
    if not vague and best <= AT_FLOOR * floor and rival > (1 + LEAST_GAIN) * best:
        return True
    if best <= OFF_FLOOR * floor and rival > CLEARLY_WORSE * near:
        return True
    return rival > FAR_WORSE * near
