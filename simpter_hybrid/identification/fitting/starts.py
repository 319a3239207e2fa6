"""Where fits of a candidate begin and how far they are carried: first steps, and to the end."""

from __future__ import annotations

from collections.abc import Mapping

from .fit import WIDE, Fit, Fitter
from .fitted_model import ENOUGH, FURTHER, Model, Trial, freed
from .predictor import Candidate
from .replay import in_windows
from .survey import Probe

#: Steps of a first fit; of a candidate that may turn out the best, `FURTHER`.
FIRST = 4
#: A first fit that leaves more than this part of the base's sum of squares is stuck.
STALLED = 1.0 - 1e-6


def grown(candidate: Candidate, simpler: Trial) -> dict[str, float]:
    """Values of a simpler form for one that contains it: what it does not know does nothing.

    A size for each clutch or joint ("1.rise") begins with that for all ("rise").  A number of the
    same name of another effect is another one.
    """
    known, old, new = simpler.fit.values, f"{simpler.candidate.name}.", f"{candidate.name}."
    own = {}
    for p in candidate.parameters:
        field = p.name.removeprefix(new)
        label, _, of_all = field.partition(".")
        same = candidate.has_of(label, simpler.candidate)
        usual = known.get(old + of_all, p.value) if same else p.value
        own[p.name] = known.get(old + field, usual)
    # By name: a declared number may be called after the effect as well ("stribeck.rise as found").
    replaced = {p.name for p in simpler.candidate.parameters}
    return {**{k: v for k, v in known.items() if k not in replaced}, **own}


def begun_with(probe: Probe, base: Model) -> Fit:
    """A first fit, carried on if it is stuck at the base's error, which it could always reach."""
    fit = _first(probe)
    return _carried_on(probe, fit) if fit.cost > STALLED * base.cost else fit


def to_its_end(probe: Probe, fit: Fit) -> Fit:
    """The fit carried on, and not held by tolerances that weigh too much."""
    return freed(probe.fitter, _carried_on(probe, fit))[1]


def grown_on(probe: Probe, simpler: Trial) -> Fit:
    """A fit that begins where that of a simpler form has ended."""
    start = grown(probe.candidate, simpler)
    return freed(probe.fitter, _anew(probe.fitter).fit(start, FURTHER, ENOUGH))[1]


def _first(probe: Probe) -> Fit:
    """A few steps from the start, at the size that one linear step asks for if that is better."""
    fitter, start, at = probe.fitter, probe.start, probe.residuals
    for scaled in (*probe.scaled, *_as_declared(probe), *_begun(probe)):
        there = fitter.residuals(scaled)
        if there @ there < at @ at:
            start, at = scaled, there
    return fitter.fit(start, FIRST, renew=False, tries=4, at=at)


def _as_declared(probe: Probe) -> list[Mapping[str, float]]:
    """The probe's starts with all parameters as declared, where the refit has left some behind.

    Without the effect that is tried a model makes up for it by parameters beyond their tolerances;
    where that holds a clutch stuck, no small step leads back.  Empty if all are within tolerances.
    """
    declared = {p.name: p for p in probe.fitter.declared}
    if all(abs(probe.start[n] - p.value) <= p.tolerance for n, p in declared.items()):
        return []
    values = {name: p.value for name, p in declared.items()}
    return [{**start, **values} for start in (probe.start, *probe.scaled)]


def _begun(probe: Probe) -> list[dict[str, float]]:
    """The end of a fit in windows, where runs are followed whole."""
    if not any(replay.followed for replay in probe.fitter.replays):
        return []
    cut = [in_windows(replay) for replay in probe.fitter.replays]
    fitter = Fitter(probe.fitter.predictor, cut, unit=probe.fitter.unit)
    return [fitter.fit(probe.start, FIRST).values]


def _carried_on(probe: Probe, fit: Fit) -> Fit:
    """The fit to its end, with columns of its own.

    Of several declared numbers set free by wide steps as well: narrow ones see one stair of a
    staircase (lags of clutches that let go at rows).
    """
    fitter = _anew(probe.fitter)
    end = fitter.fit(fit.values, FURTHER, ENOUGH, at=fit.residuals)
    if not probe.candidate.frees or len(probe.candidate.parameters) < 2:
        return end
    wide = Fitter(fitter.predictor, fitter.replays, step=WIDE, unit=fitter.unit)
    led = wide.fit(end.values, FURTHER, ENOUGH, at=end.residuals)
    return (
        end if led.cost >= end.cost else fitter.fit(led.values, FURTHER, ENOUGH, at=led.residuals)
    )


def _anew(fitter: Fitter) -> Fitter:
    """A fitter of the same model that reuses no columns of another one."""
    return Fitter(fitter.predictor, fitter.replays, unit=fitter.unit)
