"""Which part a failure came from: an exception in a part's function, or a number that is none."""

from __future__ import annotations

import math
import re
import sys
from collections.abc import Callable, Sequence
from cProfile import Profile
from types import CodeType, FrameType
from typing import Any

from ..problems import KeyPath
from .failures import at_sample

#: File name under which the assembled model is executed (``model.execute``).
MODEL_FILE = "<assembled model>"
_NAMED = re.compile(r"(load|controller|stop|effect|clutch)_(\d+)_(\w+)|(device)_(\w+)")
_SECTIONS = {"load": "loads", "stop": "stops", "effect": "effects", "clutch": "clutches"}


def part_of(function: str) -> tuple[str, KeyPath] | None:
    """``load_2_tip_force`` -> ``("load 2, tip_force", ("loads", 1))``; None for other functions.

    Parameters
    ----------
    function : str
        Its name in the assembled model.
    """
    match = _NAMED.fullmatch(function)
    if match is None:
        return None
    if match[4]:
        return f"device, {match[5]}", ("device",)
    number = int(match[2])
    name = f"{match[1]} {number}, {match[3]}"
    if match[1] == "controller":
        return name, ("controller", "stages", number - 1)
    return name, (_SECTIONS[match[1]], number - 1)


def _nearest(frame: FrameType | None) -> str | None:
    """The innermost part's function at or around a frame."""
    while frame is not None:
        code: CodeType = frame.f_code
        if code.co_filename == MODEL_FILE and part_of(code.co_name):
            return code.co_name
        frame = frame.f_back
    return None


def failing_function(error: BaseException) -> str | None:
    """Name of the part's function in which an exception was raised; None if in no part.

    Parameters
    ----------
    error : BaseException
        As caught, with its traceback.
    """
    found, step = None, error.__traceback__
    while step is not None:
        code = step.tb_frame.f_code
        if code.co_filename == MODEL_FILE and part_of(code.co_name):
            found = code.co_name
        step = step.tb_next
    return found


def part_failure(error: Exception, t: float) -> str | None:
    """What ended a run, in words; None if the exception is of no part, and so a fault of ours.

    Parameters
    ----------
    error : Exception
        As caught, with its traceback.
    t : float
        Instant that the run had reached [s].
    """
    name = part_of(failing_function(error) or "")
    if name is None:
        return None
    return f"after t = {t!r} s {name[0]} failed ({type(error).__name__}: {error})"


def first_not_finite(call: Callable[[], Any]) -> str | None:
    """Name of the first part's function that hands back a number that is not finite.

    ``call`` is run under a profile hook, so that every function of the model is seen as it returns;
    what it had written to lists by then counts as handed back.

    Parameters
    ----------
    call : callable
        Called without arguments; its ArithmeticError is swallowed.
    """
    found: list[str] = []

    def watch(frame: FrameType, event: str, result: Any) -> None:
        if event == "return" and not found and frame.f_code.co_filename == MODEL_FILE:
            values = [result, *frame.f_locals.values()]
            if any(_bad(value) for value in values) and (name := _nearest(frame)):
                found.append(name)

    previous = sys.getprofile()
    sys.setprofile(watch)
    try:
        call()
    except ArithmeticError:
        pass
    finally:
        # cProfile's own hook is no function: it has to be switched on again.
        sys.setprofile(previous if callable(previous) else None)
        if isinstance(previous, Profile):
            previous.enable()
    return found[0] if found else None


def _bad(value: Any) -> bool:
    if isinstance(value, float):
        return not math.isfinite(value)
    return isinstance(value, list) and any(
        isinstance(v, float) and not math.isfinite(v) for v in value
    )


def origin(scenario: Any, t: float, y: Sequence[float], w: Any) -> str:
    """Where a derivative that is not finite came from, in words.

    Parameters
    ----------
    scenario : Scenario
    t : float
        Instant [s].
    y : sequence of float
        State.
    w : Work
        Of the run: its modes, gates and held inputs count.
    """
    from ..kernel.motion import enter_mode, flow

    for name, value in zip(scenario.parameter_names(), scenario.parameter_values(), strict=True):
        if not math.isfinite(value):
            return f"parameter {name} is {value}"
    bad = [k for k, value in enumerate(y) if not math.isfinite(value)]
    if bad:
        return f"the state itself: {scenario.describe_entries(bad)}"
    # Work arrays of their own: those of the run are full of what is to be found.
    md = scenario.python_model()
    _, fresh = scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    for name in ("mode", "gate", "held", "dmode", "mem"):
        getattr(fresh, name)[:] = list(getattr(w, name))
    state = [float(value) for value in y]
    enter_mode(md, state, fresh)
    function = first_not_finite(lambda: flow(md, t, state, fresh, [0.0] * md.ny))
    named = part_of(function) if function else None
    return named[0] if named else "no single part: the equations of motion"


def sample_origin(
    md: Any, k: int, t: float, y: Sequence[float], w: Any, held: list[float], mem: list[float]
) -> str:
    """Which controller wrote a held input that is not finite, in words.

    ``held`` and ``mem`` are held inputs and memory before the ``k``-th sample.

    Parameters
    ----------
    md : Model
        In plain Python.
    k : int
        Number of the sample, from 0.
    t : float
        Instant [s].
    y : sequence of float (ny,)
        State.
    w : Work
        Of the run; its torques are read.
    held, mem : list of float
        Both are written again.
    """
    function = first_not_finite(
        lambda: md.control(k, t, list(y), list(w.tau), md.p, md.rec, w.s, held, mem)
    )
    named = part_of(function) if function else None
    return named[0] if named else "the controllers together"


def sample_failure(
    scenario: Any, k: int, t: float, y: Sequence[float], w: Any, held: list[float], mem: list[float]
) -> str | None:
    """Which held input is no finite number after a sample, and who wrote it; None if all are.

    Parameters
    ----------
    scenario : Scenario
    k, t, y, w, held, mem
        As for `sample_origin`; ``w.held`` is what was held.
    """
    wrong = held_not_finite(scenario, w.held)
    if wrong is None:
        return None
    name = sample_origin(scenario.python_model(), k, t, y, w, held, mem)
    return f"{at_sample(t, wrong)}; it came from {name}"


def held_names(scenario: Any) -> list[str]:
    """Held inputs by name: the commands, then what controllers hold beyond them.

    Parameters
    ----------
    scenario : Scenario
    """
    m = scenario.device.m
    return [f"the command of clutch {i + 1}" for i in range(m)] + scenario.text.a.held


def held_not_finite(scenario: Any, held: Sequence[float]) -> str | None:
    """Name of the first held input that is not a finite number; None if all are.

    Parameters
    ----------
    scenario : Scenario
    held : sequence of float
        Clutch commands, then what controllers hold beyond them.
    """
    for name, value in zip(held_names(scenario), held, strict=False):
        if not math.isfinite(value):
            return f"{name} is {value}"
    return None
