"""A candidate made of any effect: its parameters say what is fitted, and how far."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Sequence
from difflib import get_close_matches
from itertools import product

from ...assembly.model import WiringError
from ...checks.effect_check import check_effects, place_of
from ...effect import Effect
from ...problems import InvalidInput, Problem, Problems
from ..fitting.predictor import Parameter
from ..tracing.named import coordinate_of
from .effect_candidate import EffectCandidate
from .scenario_predictor import ScenarioPredictor

#: How far from its default a parameter without a bound is looked for, in typical changes.
REACH = 30.0
#: Fits begin at these multiples of the default of a parameter that shapes an effect ...
BEGINS = (0.3, 1.0, 3.0)
#: ... for so many of its shape parameters; the others begin at their default.
SHAPES = 2
PLACES = ("friction", "actuator", "load", "breakaway")


def own_candidates(
    effects: Sequence[type[Effect]],
    library: Sequence[EffectCandidate],
    predictor: ScenarioPredictor,
) -> tuple[EffectCandidate, ...]:
    """Effects to be tried beside the library, where it puts its own: on all such clutches alike.

    Parameters
    ----------
    effects : sequence of type
        Classes; a parameter with a ``typical`` size is fitted, others keep their default.
    library : sequence of EffectCandidate
        What is tried on this rig anyway.
    predictor : ScenarioPredictor
        Of the declared model.

    Raises
    ------
    InvalidInput
        If one does not say how it is to be fitted, does not go with the declared model, or is
        tried anyway.
    """
    found: list[EffectCandidate] = []
    problems: list[Problem] = []
    for cls in effects:
        missing = _unsaid(cls)
        if not missing:
            made = _candidate(cls, library, predictor)
            missing = _unfit(cls, made, (*library, *found), predictor)
            found.append(made)
        problems += missing
    if problems:
        raise InvalidInput(problems)
    return tuple(found)


def name_of(cls: type[Effect]) -> str:
    """Name of a class of effects as a scenario writes it: StickyFilm is ``sticky-film``."""
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", cls.__name__).lower()


def _unsaid(cls: type[Effect]) -> list[Problem]:
    """What a class does not say, or says wrongly, that a fit has to know."""
    where = f"--also {cls.__name__}"
    told = vars(cls).get("__annotations__", {})
    fields = {name for name, kind in told.items() if "ClassVar" not in str(kind)}
    if fields - {f.name for f in dataclasses.fields(cls)}:
        return [
            Problem(where, "", "no dataclass", cls.__name__, "@dataclass(frozen=True) above it")
        ]
    found = []
    if not place_of(cls):
        found.append(Problem(where, "", "it changes nothing", "no function", "e.g. slip_torque"))
    if cls.acts_on not in PLACES:
        right = f"one of {', '.join(PLACES)}, as a class attribute"
        found.append(Problem(where, "acts_on", "no such place", cls.acts_on or "none", right))
    fitted = [f.name for f in _fitted(cls)]
    if not fitted:
        right = "parameter(..., typical=...) of what is to be fitted"
        found.append(Problem(where, "", "nothing to be fitted", "no typical change", right))
    right = f"a tuple of {', '.join(fitted) or 'parameters with a typical change'}"
    sizes = cls.sizes if isinstance(cls.sizes, tuple) else (cls.sizes,)
    found += [
        Problem(where, "sizes", "nothing that is fitted", str(size), right)
        for size in sizes
        if size not in fitted
    ]
    return [*found, *_unbegun(cls, where)]


def _unbegun(cls: type[Effect], where: str) -> list[Problem]:
    """Parameters from whose defaults no fit can begin."""
    found = []
    for f in dataclasses.fields(cls):
        if f.default is dataclasses.MISSING:
            right = "a default: a fit has to begin somewhere"
            found.append(Problem(where, f.name, "without a default", "none", right))
        elif "dimension" in f.metadata:
            low, above, high = (f.metadata[k] for k in ("low", "above", "high"))
            value = float(f.default)
            below = (low is not None and value < low) or (above is not None and value <= above)
            if below or (high is not None and value > high) or not math.isfinite(value):
                right = "a default within the bounds of the parameter"
                found.append(Problem(where, f.name, "out of bounds", f"{value:g}", right))
    return found


def _fitted(cls: type[Effect]) -> list[dataclasses.Field]:
    return [f for f in dataclasses.fields(cls) if f.metadata.get("typical")]


def _unfit(
    cls: type[Effect],
    made: EffectCandidate,
    others: Sequence[EffectCandidate],
    predictor: ScenarioPredictor,
) -> list[Problem]:
    """Why a candidate cannot be tried."""
    where = f"--also {type(made.effect).__name__}"
    if any(made.name == c.name for c in others):
        right = "an effect that the library of this rig lacks, by a name of its own"
        return [Problem(where, "", "is tried already", made.name, right)]
    families = {c.family for c in others}
    if cls.family not in families and (near := get_close_matches(cls.family, families, 1, 0.8)):
        right = f"{near[0]}, if it is meant, or a name that is not so near to it"
        return [Problem(where, "family", "misspelt?", cls.family, right)]
    known = {coordinate_of(x) for c in others for x in c.coordinates}
    if unknown := [x for x in cls.shows_along if x not in known]:
        right = f"of {', '.join(sorted(known))}"
        return [Problem(where, "shows_along", "no such coordinate", ", ".join(unknown), right)]
    driven, problems = predictor.extended(made).driven, Problems(where)
    check_effects(driven, problems)
    try:
        problems.raise_if_any()
        _ = driven.text
    except InvalidInput as wrong:
        return list(wrong.problems)
    except WiringError as error:
        right = "functions whose arguments this model knows"
        return [Problem(where, "", "does not go with the declared model", str(error), right)]
    return []


def _candidate(
    cls: type[Effect], library: Sequence[EffectCandidate], predictor: ScenarioPredictor
) -> EffectCandidate:
    name, place, device = name_of(cls), place_of(cls), predictor.driven.device
    # Not on a clutch that stands for something else, the drag of a testbed's motor say.
    usual = {getattr(e, place) for c in library for e in c.effects()} - {-1}
    places = sorted(usual) or range(device.m if place == "clutch" else device.n)
    effects = tuple(cls(**{place: k}) for k in places)  # type: ignore[arg-type]
    parameters = tuple(_parameter(name, f) for f in _fitted(cls))
    sizes = tuple(f"{name}.{size}" for size in cls.sizes)
    return EffectCandidate(
        name, parameters, _starts(parameters, sizes), cls.family or name, cls.acts_on,
        _coordinates(cls, library), cls.reveals, effects[0], effects[1:],
        sizes=tuple(p.name for p in parameters if p.name in sizes),
    )  # fmt: skip


def _parameter(name: str, field: dataclasses.Field) -> Parameter:
    """What is fitted of a field, within its bounds or `REACH` typical changes of its default."""
    said, value = field.metadata, float(field.default)  # type: ignore[arg-type]
    typical = said["typical"]
    low, high = value - REACH * typical, value + REACH * typical
    if said["above"] is not None:
        low = max(low, said["above"] + 0.1 * min(typical, value - said["above"]))
    low = low if said["low"] is None else said["low"]
    high = high if said["high"] is None else said["high"]
    return Parameter(f"{name}.{field.name}", value, low, high, typical)


def _starts(parameters: Sequence[Parameter], sizes: Sequence[str]) -> tuple[tuple[float, ...], ...]:
    """Values from which fits of an effect begin.

    An effect with a shape is switched on either way: at size 0 no change of its shape shows.
    """
    shapes = [p for p in parameters if p.name not in sizes][:SHAPES]
    columns = []
    for p in parameters:
        begins = [p.value]
        if p in shapes and p.value:
            begins = [k * p.value for k in BEGINS]
        elif shapes and p.name in sizes:
            begins = [p.value + p.typical, p.value - p.typical]
        columns.append(dict.fromkeys(b for b in begins if p.lower <= b <= p.upper))
    return tuple(product(*columns))


def _coordinates(cls: type[Effect], library: Sequence[EffectCandidate]) -> tuple[str, ...]:
    """Coordinates of this rig on which a residual may depend where such an effect is missing.

    Those that the effect names (``shows_along``), or all of what acts where it does.
    """
    near = [c for c in library if c.acts_on == cls.acts_on] or list(library)
    every = tuple(dict.fromkeys(x for c in near for x in c.coordinates))
    told = tuple(x for x in every if coordinate_of(x) in cls.shows_along)
    return told or every
