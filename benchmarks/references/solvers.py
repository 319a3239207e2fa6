"""Every way to run the linkage: a family, settings from coarse to fine, and a call.

A call returns an `Answer` and the processor time of the run alone [s]: compiling, reading and
building are left out for everybody.
"""

from __future__ import annotations

import importlib.util
import time
from collections.abc import Callable, Iterator
from typing import NamedTuple

import with_siconos
from answer import Answer
from linkage import linkage
from same_events import story_of

from simpter_hybrid import engine, regularised
from simpter_hybrid.karnopp import FAIR, TUNED, Settings
from simpter_hybrid.program import Program, Room

#: Longest step where the tolerance is varied [s].
LONGEST = 0.5


class Way(NamedTuple):
    """One setting of one solver; `why_not` says what is absent."""

    family: str
    setting: str
    solve: Callable[[], tuple[Answer, float]] | None
    why_not: str = ""


def timed(run: Callable, *args, **kwargs):
    start = time.process_time()
    found = run(*args, **kwargs)
    return found, time.process_time() - start


def exactly(rtol: float):
    """The run without the default's longest step of 0.02 s, which alone makes it exact to 1e-15."""
    if not rtol:
        return linkage()
    return linkage().replace(rtol=rtol, atol=1e-3 * rtol, max_step=LONGEST)


def reference(rtol: float) -> tuple[Answer, float]:
    run, cpu = timed(engine.simulate, exactly(rtol))
    return Answer(run.end[:4], story_of(run)), cpu


def compiled(rtol: float, repeats: int = 20) -> tuple[Answer, float]:
    from simpter_hybrid.compiled import simulate

    scenario = exactly(rtol)
    run, program = simulate(scenario), Program(scenario)
    cases, room = program.cases(repeats), Room(400 * repeats, 0, 0)
    _, cpu = timed(program.call, cases, room)
    return Answer(run.end[:4], story_of(run)), cpu / repeats


def taylor() -> tuple[Answer, float]:
    from taylor_engine import Automaton

    Automaton(linkage()).run()  # compiles every motion
    run, cpu = timed(lambda: Automaton(linkage()).run())
    return _of_automaton(run), cpu


def cvode(rtol: float) -> tuple[Answer, float]:
    from cvode_engine import Automaton

    run, cpu = timed(lambda: Automaton(linkage(), rtol, 0.1 * rtol).run())
    return _of_automaton(run), cpu


def _of_automaton(run) -> Answer:
    from same_events import story

    return Answer(run.y[:4], story((t, after) for t, _, _, after in run.events))


def band(settings) -> tuple[Answer, float]:
    """Compiled, without a record of its steps."""
    from simpter_hybrid.karnopp.compiled import Compiled
    from simpter_hybrid.karnopp.simulate import on_grid

    ready = Compiled(linkage())
    on_grid(ready, [], settings)
    run, cpu = timed(on_grid, ready, [], settings)
    return Answer(run.end[:4], story_of(run)), cpu


def varied(rules, size: float) -> Settings:
    """A band with variable steps, which follow a hundredth of it."""
    fine = min(max(1e-2 * size, 1e-11), 1e-6)
    return Settings(size, rules=rules, rtol=fine, atol=1e-3 * fine, max_steps=400_000)


def smooth(width: float, solver: str) -> tuple[Answer, float]:
    run, cpu = timed(regularised.simulate, linkage(), width, solver, 1e-7, 1e-10)
    return Answer(run.end[:4], story_of(run)), cpu


def mujoco(step: float, hard: bool) -> tuple[Answer, float]:
    from with_mujoco import solve

    return solve(step, hard)


def ways(quick: bool = False) -> Iterator[Way]:
    """All of them, an entry without `solve` for what is absent here."""
    fine = (1e-4, 1e-6, 1e-8, 1e-10) if quick else tuple(10.0**-k for k in range(3, 13))
    sizes = (1e-2, 1e-3) if quick else (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8)
    steps = (1e-2, 1e-3) if quick else (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5)
    yield from _each("exact, reference", "rtol", (*fine, 0.0), reference)
    yield from _each("exact, compiled", "rtol", (*fine, 0.0), compiled, needs="llvmlite")
    yield from _each("heyoka (Taylor)", "tolerance", (2.2e-16,), lambda _: taylor(), "heyoka")
    yield from _each("CVODE, root finding", "rtol", fine[1::2], cvode, "sksundae")
    for rules, word in ((FAIR, "fair"), (TUNED, "tuned")):
        yield from _each(
            f"Karnopp, {word}", "band", sizes, lambda b, r=rules: band(varied(r, b)), "numba"
        )  # fmt: skip
    yield from _each(
        "Karnopp, fixed step", "step = band", steps,
        lambda h: band(Settings(h, "fixed", h, TUNED, max_steps=400_000)), "numba",
    )  # fmt: skip
    for solver in ("LSODA", "Radau"):
        widths = sizes[:2] if quick else sizes[1:5]
        yield from _each(f"tanh, {solver}", "width", widths, lambda s, w=solver: smooth(s, w))
    for hard, word in ((True, "hard"), (False, "defaults")):
        yield from _each(
            f"MuJoCo, {word}", "step", steps, lambda h, w=hard: mujoco(h, w), "mujoco"
        )  # fmt: skip
    if with_siconos.available():
        yield from _each("Siconos (Moreau-Jean)", "step", steps[:5], with_siconos.solve)
    else:
        yield Way("Siconos (Moreau-Jean)", "", None, "Debian's python3-siconos is absent")


def _each(family, word, sizes, solve, needs: str = "") -> Iterator[Way]:
    if needs and importlib.util.find_spec(needs) is None:
        yield Way(family, "", None, f"{needs} is not installed")
        return
    for size in sizes:
        setting = f"{word} {size:.2g}" if size else "default"
        yield Way(family, setting, lambda s=size: solve(s))
