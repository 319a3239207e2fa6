"""Whether the stages of a controller keep to their arrays, at the first sample.

An index one too far changes what is another's, or nothing, without a word: commands, memory and
the state are parts of longer arrays, and the compiled engine looks at no bounds.
"""

from __future__ import annotations

from typing import Any

from ..controller import Controller
from ..kernel.records import Model
from ..part import arguments_of
from ..problems import KeyPath, Problems
from ..scenario import Scenario


class Beyond(IndexError):
    """An index outside what is a stage's own."""

    def __init__(self, name: str, written: str, text: str) -> None:
        super().__init__(f"{name} {written} {text}")
        self.name, self.written, self.text = name, written, text


class Window:
    """Entries ``first`` to ``end - 1`` of an array under their numbers there; others are refused.

    Parameters
    ----------
    name : str
        The array's name in messages.
    data : list of float
        Read and written.
    first, end : int
    """

    def __init__(self, name: str, data: list[float], first: int, end: int) -> None:
        self.name, self.data, self.first, self.end = name, data, first, end

    def __len__(self) -> int:
        return self.end

    def __getitem__(self, at: Any) -> Any:
        self._inside(at, "reads")
        return self.data[at]

    def __setitem__(self, at: Any, value: Any) -> None:
        self._inside(at, "writes")
        self.data[at] = value

    def _inside(self, at: Any, verb: str) -> None:
        """Refuse what is outside; a slice is, where one of its ends is."""
        if isinstance(at, slice):
            first = self.first if at.start is None else at.start
            inside = self.first <= first and (at.stop is None or at.stop <= self.end)
            text = f"{first}:{'' if at.stop is None else at.stop}"
        else:
            inside, text = self.first <= at < self.end, str(at)
        if not inside:
            if self.name == "mem":
                text = f"mem_at + {at - self.first}" if isinstance(at, int) else text
            raise Beyond(self.name, verb, f"{self.name}[{text}]")


def check_stages(s: Scenario, md: Model, problems: Problems) -> bool:
    """Record stages that read or write beyond what is theirs, or return something.

    What else fails in them is left to be found where the model is evaluated.

    Parameters
    ----------
    s : Scenario
    md : Model
        Of the scenario, in plain Python.
    problems : Problems

    Returns
    -------
    bool
        Whether there was one.
    """
    y, w = s.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    arrays = {"k": 0, "t": 0.0, "y": y, "tau": w.tau, "p": md.p, "rec": md.rec, "s": w.s,
              "held": w.held, "mem": w.mem}  # fmt: skip
    stages = zip(s.controllers, s.text.a.stages, strict=True)
    for k, ((stage, _), (given, first)) in enumerate(stages):
        path: KeyPath = ("controller", "stages", k)
        names = arguments_of(stage.functions()["step"])
        space = md.control.__globals__
        step, end = space[f"controller_{k + 1}_step"], first + len(stage.memory)
        ranges = {"q": (0, md.n), "qd": (0, md.n), "tau": (0, md.m), "held": (0, s.sizes()["nh"])}
        ranges["mem"] = (first, end)
        try:
            values = {name: eval(given[name], space, arrays) for name in names}
            windows = {a: Window(a, values[a], *ranges[a]) for a in names if a in ranges}
            returned = step(*(values | windows).values())
        except Beyond as error:
            what = f"{type(stage).__name__}.step {error.written} beyond {error.name}"
            right = _right(s, stage, error.name, *ranges[error.name])
            problems.add(path, what, error.text, right)
            return True
        except (Exception, SystemExit):  # whatever a user's function does
            return False
        if returned is not None:
            what = f"{type(stage).__name__}.step returns what nobody reads"
            right = "no return value: commands are written, held[0] = ... for the first clutch"
            problems.add(path, what, returned, right)
            return True
    return False


def _right(s: Scenario, stage: Controller, name: str, first: int, end: int) -> str:
    """What a stage may read and write of an array."""
    if name == "mem":
        if not stage.memory:
            return 'memory = ("name", ...) in the class, one name for each cell; it has none'
        cells = ", ".join(f"mem[mem_at + {i}]" for i in range(min(end - first, 4)))
        more = ", ..." if end - first > 4 else ""
        return f"{cells}{more}; memory = (...) in the class names {end - first}, each is one cell"
    known = ", ".join(s.device.surfaces if name in ("tau", "held") else s.device.coordinates)
    if end == 0:
        return f"no use of {name}, which has no entry here"
    span = f"{name}[0]" if end == 1 else f"{name}[0] to {name}[{end - 1}]"
    held = end - s.device.m if name == "held" else 0
    beyond = f", and {held} that controllers hold beyond these" if held else ""
    return f"{span}, numbered from 0: {known}{beyond}"
