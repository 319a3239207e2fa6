"""Every way to run the linkage: a family, settings from coarse to fine, and a call.

A call returns an `Outcome`: compiling, reading and building are left out of its processor time.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Callable, Iterator
from functools import partial
from typing import NamedTuple

import with_siconos
from compiled_engine_peers import Outcome, automaton, bare, karnopp, mujoco, of_trajectory
from linkage import linkage

from simpter_hybrid import engine, regularised
from simpter_hybrid.karnopp import FAIR, TUNED, Settings

#: Longest step where the tolerance is varied [s].
LONGEST = 0.5


class Way(NamedTuple):
    """One setting of one solver; `why_not` says what is absent."""

    family: str
    setting: str
    solve: Callable[[], Outcome] | None
    why_not: str = ""


def exactly(rtol: float):
    """The run without the default's longest step of 0.02 s, which alone makes it exact to 1e-15."""
    if not rtol:
        return linkage()
    return linkage().replace(rtol=rtol, atol=1e-3 * rtol, max_step=LONGEST)


def reference(rtol: float) -> Outcome:
    return of_trajectory(engine.simulate, exactly(rtol))


def taylor(_: float = 0.0) -> Outcome:
    return automaton("taylor_engine", "Automaton", linkage())


def cvode(rtol: float) -> Outcome:
    return automaton("cvode_engine", "Automaton", linkage(), rtol, 0.1 * rtol)


def band(rules, size: float, share: float = 1e-2) -> Outcome:
    """A band with variable steps whose tolerance is a share of it."""
    fine = min(max(share * size, 1e-11), 1e-2)
    settings = Settings(
        size, rules=rules, rtol=fine, atol=1e-3 * fine, max_step=5e-3, max_steps=400_000
    )
    return karnopp(linkage(), settings)


def band_fixed(share: float, step: float) -> Outcome:
    return karnopp(linkage(), Settings(share * step, "fixed", step, TUNED, max_steps=400_000))


def bands(quick: bool, sizes, steps) -> Iterator[Way]:
    """Karnopp: bands beside tolerances and steps, so that its best can be found."""
    yield from _each("Karnopp, fair", "band", sizes, partial(band, FAIR), "llvmlite")
    for share in (1e-2,) if quick else (1.0, 1e-1, 1e-2, 1e-3):
        word = f"rtol {share:g} of band"
        yield from _each(
            "Karnopp, tuned", word, sizes, partial(band, TUNED, share=share), "llvmlite"
        )
    for share in (1.0,) if quick else (10.0, 1.0, 1e-1, 1e-2):
        word = f"band {share:g}/s of step"
        solve = partial(band_fixed, share)
        yield from _each("Karnopp, fixed step", word, steps[:5], solve, "llvmlite")


def smooth(solver: str, width: float) -> Outcome:
    simulate = partial(regularised.simulate, width=width, solver=solver, rtol=1e-7, atol=1e-10)
    return of_trajectory(simulate, linkage())


def siconos(step: float) -> Outcome:
    answer, cpu = with_siconos.solve(step)
    return Outcome(cpu, answer.story, answer.end)


def ways(quick: bool = False) -> Iterator[Way]:
    """All of them, an entry without `solve` for what is absent here."""
    fine = (1e-4, 1e-6, 1e-8, 1e-10) if quick else tuple(10.0**-k for k in range(3, 13))
    sizes = (1e-2, 1e-3) if quick else (1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8)
    steps = (1e-2, 1e-3) if quick else (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5)
    yield from _each("exact, reference", "rtol", (*fine, 0.0), reference)
    yield from _each(
        "exact, compiled", "rtol", (*fine, 0.0), lambda r: bare(exactly(r), True), "llvmlite"
    )  # fmt: skip
    yield from _each("heyoka (Taylor)", "tolerance", (2.2e-16,), taylor, "heyoka")
    yield from _each("CVODE, root finding", "rtol", fine[1::2], cvode, "sksundae")
    yield from bands(quick, sizes, steps)
    for solver in ("LSODA", "Radau"):
        widths = sizes[:2] if quick else sizes[1:5]
        yield from _each(f"tanh, {solver}", "width", widths, partial(smooth, solver))
    for hard, word in ((True, "hard"), (False, "defaults")):
        yield from _each(f"MuJoCo, {word}", "step", steps, partial(mujoco, hard=hard), "mujoco")
    if with_siconos.available():
        yield from _each("Siconos (Moreau-Jean)", "step", steps[:5], siconos)
    else:
        yield Way("Siconos (Moreau-Jean)", "", None, "Debian's python3-siconos is absent")


def _each(family, word, sizes, solve, needs: str = "") -> Iterator[Way]:
    if needs and importlib.util.find_spec(needs) is None:
        yield Way(family, "", None, f"{needs} is not installed")
        return
    for size in sizes:
        setting = f"{word} {size:.2g}" if size else "default"
        yield Way(family, setting, partial(solve, size))
