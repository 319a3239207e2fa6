"""Why a run cannot go on, in words: what, and what to do; the same for both engines."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from ..kernel.records import FACET_LIMIT
from ..kernel.rules import AT_ONCE

if TYPE_CHECKING:
    from ..scenario import Scenario
    from ..trajectory import Event

#: Why no mode is found, by the kernel's status.
NO_MODE = {
    1: "the mass matrix is singular: every coordinate needs an inertia; check masses, inertias and "
    "the configuration",
    2: "mode resolution did not end: no friction torques were found that hold the stuck clutches; "
    "check for inertias, limits or lever arms of very different size",
    3: "the stuck set's constraint is singular: at this configuration the clutch map has a row of "
    "zeros, or no finite numbers",
    4: f"a stuck set has more than {FACET_LIMIT} facets: let fewer clutches be locked at once, or "
    "merge those that hold the same coordinate",
    5: "no consistent mode was found (cascade limit): each mode tried breaks at once; check what "
    "makes a clutch's limit depend on the mode it is in (an effect, a load)",
}


STALLED = (
    "the run stands still: its steps have become too short to end it; a part is too stiff for the "
    "solver (a very short time constant, a very stiff spring) or changes without limit there"
)
#: A caller's own limit (`Program.call`), which is no key of a file.
MANY_STEPS = (
    "more steps than its caller allows (step_limit): a part is too stiff for the solver, or the "
    "limit too low for so long a run"
)
#: What the compiled engine can say of such a number.
NOT_FINITE = "the derivative is not finite; the engine 'reference' names the part that it came from"


#: A coordinate or speed beyond this is on its way to what no number holds (SI).
BOUNDLESS = 1e100
#: A mass matrix whose smallest eigenvalue is less than this of what it was at the start is as good
#: as singular: a solver gives up some digits before 0, at 1e-9 where a mass falls linearly.
VANISHED = 1e-6


def boundless(scenario: Scenario, y: Sequence[float]) -> list[int]:
    """Which coordinates and speeds of the state `y` are beyond all bounds.

    Parameters
    ----------
    scenario : Scenario
    y : sequence of float (ny,)

    Returns
    -------
    list of int
        Their places in `y`, from 0.
    """
    return [k for k in range(2 * scenario.device.n) if not abs(y[k]) < BOUNDLESS]


def vanished_mass(scenario: Scenario, t: float, y: Sequence[float]) -> str | None:
    """Where the mass matrix has all but vanished, in words; None if it has not.

    Parameters
    ----------
    scenario : Scenario
    t : float
        Instant [s].
    y : sequence of float (ny,)
        State there.
    """
    md, n = scenario.python_model(), scenario.device.n
    start, w = scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)

    def mass(t: float, y: list[float]) -> np.ndarray:
        md.terms(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr)
        return np.array(w.M[: n * n]).reshape(n, n)

    first, last = mass(0.0, start), mass(t, [float(v) for v in y])
    # In the coordinates' own units, whatever those are.
    size = np.sqrt(np.abs(np.diag(first)))
    scale = np.outer(size, size)
    if not np.isfinite(last / scale).all():
        return None
    left = float(np.linalg.eigvalsh(last / scale)[0] / np.linalg.eigvalsh(first / scale)[0])
    if not left < VANISHED:
        return None
    at = ", ".join(
        f"{name} = {float(value):.6g}"
        for name, value in zip(scenario.device.coordinates, y, strict=False)
    )
    return (
        f"the mass matrix vanishes at {at} (SI): its smallest eigenvalue is {left:.1g} of what it "
        "was at the start; check the device's mass_matrix, or end the run before by a stop"
    )


def stands_still(scenario: Scenario, t: float, y: Sequence[float] | None) -> str:
    """Why a run stands still; the state `y` at `t` [s], where it is known, may tell.

    Parameters
    ----------
    scenario : Scenario
    t : float
    y : sequence of float (ny,), optional
    """
    return (vanished_mass(scenario, t, y) if y is not None else None) or STALLED


def gave_up(scenario: Scenario, t: float, y: Sequence[float], reason: str) -> str:
    """Why SciPy's solver takes no further step from `y` at `t` [s]; `reason` is what it says.

    Parameters
    ----------
    scenario : Scenario
    t : float
    y : sequence of float (ny,)
    reason : str
    """
    beyond = boundless(scenario, y)
    if not beyond:
        if why := vanished_mass(scenario, t, y):
            return f"at t = {float(t)!r} s {why}"
        return f"the solver gave up at t = {float(t)!r} s: {reason}"
    return (
        f"at t = {float(t)!r} s the motion has grown without bound: "
        f"{scenario.describe_entries(beyond[-1:])} is {float(y[beyond[-1]]):.3g} (SI); check what "
        "gives energy without end (a negative damping or stiffness, a loop's gain or sign)"
    )


def at_sample(t: float, wrong: str) -> str:
    """A sample holds what is no finite number.

    Parameters
    ----------
    t : float
        Its instant [s].
    wrong : str
        Which held input it is, and what it is.
    """
    return f"at the sample at t = {t!r} s {wrong}"


def too_many(limit: int) -> str:
    """More events in a run than are allowed.

    Parameters
    ----------
    limit : int
        That was exceeded.
    """
    return f"more than {limit} events (event_limit of [run], which may be raised)"


def last_events(events: Sequence[Event]) -> str:
    """The last three of the events before a run was given up for their number.

    Parameters
    ----------
    events : sequence of Event
    """
    return "last: " + "; ".join(
        f"t = {e.t!r} s {e.kind} clutch {e.clutches}: {e.before} -> {e.after}" for e in events[-3:]
    )


def at_once(count: int) -> str:
    """Events that have no end.

    Parameters
    ----------
    count : int
        That fell together.
    """
    span = np.format_float_scientific(AT_ONCE, trim="-", exp_digits=1)
    return (
        f"{count} events within {span} s (Zeno): a mode is entered and left again without end; "
        "check what changes with the slip's direction or at a stop"
    )


def incompatible(which: int, others: str, at: str = "") -> str:
    """Clutch `which` is locked together with `others`, which the configuration no longer allows.

    Parameters
    ----------
    which : int
        From 0.
    others, at : str
        What the message says in their places.
    """
    return (
        f"incompatible locking: clutch {which + 1} was locked together with {others} where they "
        f"left it no motion, but the configuration has changed and it would now slip{at}; three or "
        "more locks at once need a map that stays dependent; let one of them go (a lower command) "
        "or change the clutch map"
    )
