"""Engines and simulators that are put beside the compiled engine, each as CPU seconds of a run."""

from __future__ import annotations

import importlib
import importlib.util
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE.parent / "tests"), str(HERE / "references")]

from same_events import first_difference, story, story_of  # noqa: E402

from simpter_hybrid import compiled, engine  # noqa: E402
from simpter_hybrid.karnopp import TUNED, Settings  # noqa: E402
from simpter_hybrid.machine_code.program import Program, Room  # noqa: E402
from simpter_hybrid.scenario import Scenario  # noqa: E402

Story = list[tuple[float, tuple[int, ...]]]


class Outcome(NamedTuple):
    """CPU seconds of a run; what it says, if asked: transitions, final angles and speeds."""

    cpu: float
    story: Story
    end: np.ndarray


class Peer(NamedTuple):
    """A way to solve a scenario; ``needs``: a package; ``linkage``: serves that run only."""

    name: str
    solve: Callable[[Scenario], Outcome]
    needs: str = ""
    linkage: bool = False

    @property
    def installed(self) -> bool:
        return not self.needs or importlib.util.find_spec(self.needs) is not None


def timed(function: Callable, *args, **kwargs):
    """CPU seconds of a call, and what it returned."""
    start = time.process_time()
    found = function(*args, **kwargs)
    return time.process_time() - start, found


def of_trajectory(simulate: Callable, run: Scenario) -> Outcome:
    cpu, found = timed(simulate, run)
    return Outcome(cpu, story_of(found), found.end[:4])


def bare(run: Scenario, together: bool, repeats: int = 20) -> Outcome:
    """A run without records; from ``repeats`` in one call, as a sweep has them."""
    program = Program(run, together)
    cases, room = program.cases(repeats), Room(400 * repeats, 0, 0)
    cpu, found = timed(program.call, cases, room)
    count = found.kept(0, 1)[0]
    events = compiled.events_of(run, found.records["event_t"], found.records["event_i"], 0, count)
    return Outcome(cpu / repeats, story((e.t, e.after) for e in events), found.end[0, :4])


def automaton(module: str, name: str, run: Scenario, *tolerances: float) -> Outcome:
    """An engine of the tests: its own events and equations."""
    made = getattr(importlib.import_module(module), name)
    cpu, found = timed(lambda: made(run, *tolerances).run())
    return Outcome(cpu, story((t, after) for t, _, _, after in found.events), found.y[:4])


def karnopp(run: Scenario, settings: Settings | None = None) -> Outcome:
    """Karnopp's model, compiled; by default as near to the exact run as the time spent allows."""
    from simpter_hybrid.karnopp.compiled import Compiled
    from simpter_hybrid.karnopp.simulate import on_grid

    settings = settings or Settings(1e-4, rules=TUNED, rtol=1e-6, atol=1e-9, max_steps=20_000)
    cpu, found = timed(on_grid, Compiled(run), [], settings)
    return Outcome(cpu, story_of(found), found.end[:4])


def mujoco(step: float = 1e-4, hard: bool = True) -> Outcome:
    """The linkage as two hinged bodies, friction as hard as it gets or as soft as by default."""
    from with_mujoco import solve

    answer, cpu = solve(step, hard)
    return Outcome(cpu, answer.story, answer.end)


PEERS = (
    Peer("reference", lambda run: of_trajectory(engine.simulate, run)),
    Peer("compiled, with record", lambda run: of_trajectory(compiled.simulate, run)),
    Peer("compiled, split", lambda run: bare(run, False)),
    Peer("compiled, together", lambda run: bare(run, True)),
    Peer("heyoka.py", lambda run: automaton("taylor_engine", "Automaton", run), "heyoka"),
    Peer("CyRK", lambda run: automaton("cyrk_engine", "CyrkAutomaton", run), "CyRK"),
    Peer(
        "scikit-sundae (CVODE)", lambda run: automaton("cvode_engine", "Automaton", run), "sksundae"
    ),
    Peer("Karnopp, tuned", karnopp, "llvmlite"),
    Peer("MuJoCo, 0.1 ms", lambda run: mujoco(), "mujoco", linkage=True),
)


def accuracy(outcomes: list[Outcome], exact: list[Outcome]) -> tuple[str, str]:
    """Runs with other transitions; largest errors of their instants [s] and of final states."""
    pairs = list(zip(outcomes, exact, strict=True))
    right = [(o, e) for o, e in pairs if not first_difference(e.story, o.story, 0.02)]
    wrong = f"{len(pairs) - len(right)} of {len(pairs)}"
    if not right:
        return wrong, "-"
    shift = max(abs(a[0] - b[0]) for o, e in right for a, b in zip(o.story, e.story, strict=True))
    state = max(float(np.abs(o.end - e.end).max()) for o, e in right)
    return wrong, f"{shift:.0e} s, {state:.0e}"
