"""Declared parameters that were refitted farther than their tolerances let expect."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from math import floor, isfinite, log10
from typing import Any

from ..axis.sizes import pulls_back
from ..fitting.predictor import Parameter
from ..result import Diagnosis
from ..unexplained import FAR

#: Declared parameters that all changed by one factor, within so much: a gain.
ALIKE = 0.02
#: Correlation of the estimates of two numbers that are known together alone.
TOGETHER = 0.99
#: What is left of a number that fell far, beyond its tolerance: of one declared to half of itself
#: no fall is two tolerances.
LITTLE = 0.2
#: Where a declared parameter was refitted to.
FAR_BEYOND = "Refitted far beyond its tolerance"
BEYOND = "Refitted beyond its tolerance"
AT_ITS_END = "Refitted to the end of what is tried, though within its tolerance"


def far_refits(found: Diagnosis) -> list[str]:
    """Each declared parameter that went far, or as far as is tried, and by how much."""
    ended = _ended(found)
    return [_told(p, off, ended) for p, off in _alone(found).items() if _far(p, off) or p in ended]


def _ended(found: Diagnosis) -> set[Parameter]:
    """Declared parameters that went as far as is tried."""
    values = found.search.corrected.values
    return {p for p in _refitted(found) if p.at_limit(values[p.name])}


def _told(p: Parameter, off: float, ended: Collection[Parameter]) -> str:
    limit = ", and no farther is tried" * (p in ended)
    return f"{p.name} {_off_text(p, off)} % (declared to {100 * p.tolerance:g} %{limit})"


def _off_text(p: Parameter, off: float) -> str:
    """A change in per cent, to a tenth or as much finer as its tolerance is."""
    decimals = max(1, 1 - floor(log10(100 * p.tolerance)))
    return f"{100 * off:+.{decimals}f}"


def _beyond(p: Parameter, off: float) -> bool:
    """Whether what is told of a change is beyond what is told of its tolerance."""
    return abs(float(_off_text(p, off))) > float(f"{100 * p.tolerance:g}")


def refits_told(found: Diagnosis, parameters: Sequence[Mapping[str, Any]]) -> str:
    """`refit_sentence` and `traded_sentence`, as far as there is something to tell."""
    return " ".join(filter(None, (refit_sentence(found), traded_sentence(found, parameters))))


def traded_sentence(found: Diagnosis, parameters: Sequence[Mapping[str, Any]]) -> str:
    """Which declared numbers are only known together with one that was refitted far; "" if none.

    A fit takes those which their tolerances hold least, whichever is wrong: of a flywheel whose
    motor gives less than declared it said another inertia.

    Parameters
    ----------
    found : Diagnosis
    parameters : sequence of mapping
        Rows as of `parameter_rows`.
    """
    by = {p.name: (p, off) for p, off in _refitted(found).items()}
    pairs = [
        (row["name"], row["with"])
        for row in parameters
        if row["name"] in by and row["with"] in by and abs(row["largest_correlation"]) > TOGETHER
    ]
    far = {name for name, (p, off) in by.items() if _far(p, off)}
    said = [
        f"These data tell {one} and {other} only together (their estimates move as one): either or "
        "both may be off."
        for one, other in pairs
        if one in far and other not in far
    ]
    return " ".join(said)


def refit_sentence(found: Diagnosis) -> str:
    """Declared parameters that were refitted farther than is usual; "" if none was.

    Those that went far come first, then those that went beyond their tolerances, then those that
    stayed within and ended as far as is tried: such a value is no estimate.
    """
    told: dict[str, list[str]] = {}
    ended = _ended(found)
    for p, off in _alone(found).items():
        how = FAR_BEYOND if _far(p, off) else BEYOND if _beyond(p, off) else AT_ITS_END
        if how != AT_ITS_END or p in ended:
            told.setdefault(how, []).append(_told(p, off, ended))
    order = (FAR_BEYOND, BEYOND, AT_ITS_END)
    return " ".join(f"{how}: {', '.join(told[how])}." for how in order if how in told)


def one_factor_text(found: Diagnosis) -> str:
    """What is said after a verdict where all that was declared changed by one factor; else "".

    And by more than one of its tolerances.  It is what no motion tells from a sensor of force with
    another gain; and where nothing is measured that acts, and no weight or spring of a known size
    does, from another inertia.
    """
    by = _refitted(found)
    one = len(by) > 1 and max(by.values()) - min(by.values()) <= ALIKE
    if not one or all(abs(off) <= p.tolerance for p, off in by.items()):
        return ""
    model: Any = found.search.corrected
    ended = all(p.at_limit(model.values[p.name]) for p in by)
    if ended or any(e.acts_on == "sensor" for e in model.effects):
        return ""
    driven = found.recording is None or found.recording.map.driven
    if not driven and pulls_back(model.predictor.declared):
        return ""
    alike = (
        "a force or torque sensor, or a drive, of another gain"
        if driven
        else "a mass or an inertia of another size"
    )
    times = 1.0 + sum(by.values()) / len(by)
    return (
        f" All that is declared with a tolerance is refitted by one factor, {times:.3g}: {alike} "
        "would look the same."
    )


def _far(parameter: Parameter, off: float) -> bool:
    """Whether a change by the part `off` is far."""
    fallen = off < -parameter.tolerance and 1.0 + off < LITTLE
    return abs(off) > FAR * parameter.tolerance or fallen


def _refitted(found: Diagnosis) -> dict[Parameter, float]:
    """By which part each parameter with a tolerance was changed."""
    model = found.search.corrected
    declared = [p for p in model.predictor.parameters if isfinite(p.tolerance)]
    return {p: model.values[p.name] / p.value - 1.0 for p in declared}


def _alone(found: Diagnosis) -> dict[Parameter, float]:
    """As `_refitted`, without what stands for a share of the same numbers that was found.

    The two are known as their product alone, which is told among the sizes.
    """
    model = found.search.corrected
    shared = {number for e in model.effects for _, number in getattr(e, "shares", ())}
    if not shared:
        return _refitted(found)
    predictor: Any = model.predictor
    groups = predictor.declared.notes.get("tolerances", ())
    gone = {t["name"] for t in groups if shared.issuperset(t["parameters"])}
    return {p: off for p, off in _refitted(found).items() if p.name not in gone}
