"""A model that errs far more than if nothing had moved: a search from there finds nothing."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import product
from typing import Any, cast

import numpy as np

from ..problems import InvalidInput, Problem
from ..scenario import Scenario
from .axis.signals import AxisSignals
from .channel_factors import with_columns_exchanged
from .doubted_channels import least_wrong
from .fitting.fit import WIDE, Fitter
from .fitting.floor import noise_floor
from .fitting.replay import Replay
from .fitting.residual import over_rest, rms, weighted_residuals
from .numbers_instead import driving_numbers, numbers_instead
from .percent import percent
from .recordings.recording import Recording
from .rigs.bench import Bench

#: A model that errs so many times as much as if nothing moved is a model of something else ...
HOPELESS = 3.0
#: ... unless one of these brings it below that: a joint that a servo holds at one speed hardly
#: changes, and one without its viscous friction ran away from that five times as far ...
EASING = ("viscous-drag", "friction-scale", "bias-force")
#: ... and not because it now rests where something moves: so near to what no motion at all leaves,
#: and that many times the noise.
RESTS, MOVES_BY = 0.01, 3.0
#: A number or a factor on what is measured is told if it leaves so small a part of what no motion
#: at all does: with a huge inertia, whatever is wrong, a model rests and errs far less.
OF_REST = 0.5
#: Signals of what moves.
MOVES = ("speed", "position")
#: Iterations of their fits.
ITERATIONS = 6


def refuse_hopeless(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    fitted: Mapping[str, float],
    parts: Mapping[str, Sequence[Replay]],
) -> None:
    """Refuse a refitted model that errs far more on the selecting runs than if nothing had moved.

    Parameters
    ----------
    bench : Bench
        Its predictor is the declared model.
    recording : Recording
    values, fitted : mapping of str to float
        As declared, and refitted.
    parts : mapping of str to sequence of Replay
        The runs that ``fit`` and those that ``select``.

    Raises
    ------
    InvalidInput
        With what may be wrong: columns, a factor on a channel, one declared number.
    """
    predictor, replays = cast(Any, bench.predictor), parts["select"]
    times = over_rest(predictor.predict(fitted, replays), replays)
    if not times > HOPELESS or _eased(bench, fitted, parts["fit"], replays):
        return
    what = "the refitted model errs more than if nothing had changed since each window began"
    right = "the columns, units and signs of what drives and what moves; the model's numbers"
    most = OF_REST / times
    numbers = numbers_instead(predictor, fitted, parts["fit"], replays, most)
    if numbers:
        told = (f"{one.said} leaves {percent(one.left)} of the error" for one in numbers)
        right += f": {' and '.join(told)} (one at a time, the others refitted)"
    else:
        right += _of_the_drive(predictor.declared)
    device = predictor.declared.device
    if getattr(device, "weight", 0.0) and hasattr(device, "hanging"):
        right += ", and where its weight hangs (the device's `hanging`, or 180 deg of `offset`)"
    right += "".join(_nearest(bench, recording, values, fitted, replays, most))
    right += exchanged_columns(bench, recording, values, "select", HOPELESS)
    got = f"{times:.3g} times as much"
    raise InvalidInput([Problem(recording.map.source, "channels", what, got, right)])


def _nearest(
    bench: Bench,
    recording: Recording,
    values: Mapping[str, float],
    fitted: Mapping[str, float],
    replays: Sequence[Replay],
    most: float,
) -> Iterator[str]:
    """Words on the factors on what drives, and on what is measured, that leave least.

    The latter only if it leaves no more than `most`: beside a huge motion any model rests.
    """
    error = rms(weighted_residuals(cast(Any, bench.predictor), fitted, replays))
    for role, said in (("input", "drives"), ("measured", "is measured")):
        best = least_wrong(bench, recording, values, replays, error, role)
        if best is not None and (role == "input" or best.left <= most):
            left = f"{best.changed} leaves {percent(best.left)} of the error"
            yield f"; of factors on what {said} {left}, and none less"


def _eased(
    bench: Bench,
    fitted: Mapping[str, float],
    runs: Sequence[Replay],
    replays: Sequence[Replay],
) -> bool:
    """Whether a drag, more friction or a constant force brings a model near to what moves."""
    predictor: Any = bench.predictor
    for candidate in (c for c in bench.candidates if c.name in EASING):
        extended = predictor.extended(candidate)
        names = [p.name for p in candidate.parameters]
        begin = {**fitted, **dict(zip(names, candidate.starts[0], strict=True))}
        fit = Fitter(extended, runs, step=WIDE).fit(begin, iterations=ITERATIONS)
        times = over_rest(extended.predict(fit.values, replays), replays)
        rests = abs(times - 1.0) < RESTS and _beyond_noise(extended, fit.values, replays)
        if times <= HOPELESS and not rests:
            return True
    return False


def _beyond_noise(predictor: Any, values: Mapping[str, float], replays: Sequence[Replay]) -> bool:
    error = rms(weighted_residuals(predictor, values, replays))
    return error > MOVES_BY * noise_floor(replays)


def _of_the_drive(declared: Scenario) -> str:
    """Words on the numbers of what drives: with one far off no refit within tolerances is near."""
    numbers = driving_numbers(declared).items()
    told = [f"{name} ({value:.4g} in SI units)" for name, value in numbers]
    if not told:
        return ""
    return f", of the drive {' and '.join(told)}: a wider tolerance lets one be fitted"


def exchanged_columns(
    bench: Bench, recording: Recording, values: Mapping[str, float], part: str, most: float
) -> str:
    """Words on what drives an axis and what moves, where the model fits each's other column.

    That is if the model as declared then errs no more than `most` times as much as if nothing had
    moved; else "".
    """
    channels, predictor = recording.channels, cast(Any, bench.predictor)
    drives = [n for n in AxisSignals().drive if n in channels and channels[n].role == "input"]
    # A position that is a speed summed up would go on as it was.
    summed = any(c.summed for c in channels.values())
    moves = [n for n in MOVES if n in channels and not summed]
    for pair in product(drives, [n for n in moves if channels[n].role == "measured"]):
        seen = (r.channels.get(name, np.full(1, np.nan)) for r in recording.runs for name in pair)
        if not all(np.isfinite(column).all() for column in seen):
            continue
        runs = bench.made(with_columns_exchanged(recording, *pair), part)
        errs = over_rest(predictor.predict(values, runs), runs)
        if 0.0 < errs <= most:
            return (
                f"; or are the columns of {' and '.join(pair)} exchanged? So the model as declared "
                f"errs {errs:.3g} times as much as if nothing had moved"
            )
    return ""
