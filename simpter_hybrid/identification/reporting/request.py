"""What a diagnosis is asked for: files, and how far to go; read and checked at once."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...effect import Effect
from ...files.scenario_file import load
from ...problems import InvalidInput, Problem, together
from ...reading.kinds import UnknownKindError, find
from ...scenario import Scenario
from ..maps import find_map, find_model
from ..recordings.recording import Recording, load_recording
from ..rigs.scenario_runner import threads
from .sources import digests, name_of

#: A file's name.
File = str | os.PathLike[str]


@dataclass(frozen=True)
class Request:
    """A recording, what is declared of its rig, and how far a diagnosis of it goes.

    Parameters
    ----------
    files : tuple of str
        Of the recording.
    model, map : Path
        Files of the declared model and of the map.
    declared : Scenario
    recording : Recording
    also : tuple of type
        Effects of one's own that are tried beside the library.
    without : tuple of str
        Effects that are not tried, by their names in verdicts.
    effort : float
        How much may be simulated, in times the usual.
    trials : int
        Synthetic sets of these runs in which nothing is missing that are diagnosed as well.
    sight : bool
        Whether it is asked what these experiments cannot show, and which run would tell most.
    digests : mapping of str to str
        SHA-256 of the files as they were when they were read.
    map_text : str
        The map as it was then.
    """

    files: tuple[str, ...]
    model: Path
    map: Path
    declared: Scenario
    recording: Recording
    also: tuple[type[Effect], ...] = ()
    without: tuple[str, ...] = ()
    effort: float = 1.0
    trials: int = 0
    sight: bool = True
    digests: Mapping[str, str] = field(default_factory=dict)
    map_text: str = ""

    @property
    def name(self) -> str:
        """What the diagnosis is called."""
        return name_of(self.files)

    @property
    def asked(self) -> dict[str, Any]:
        """What was asked besides, by the names of the command's options."""
        also = [f"{kind.__module__}:{kind.__qualname__}" for kind in self.also]
        return {"effort": self.effort, "trials": self.trials, "sight": self.sight,
                "also": also, "without": list(self.without)}  # fmt: skip

    @property
    def left_out(self) -> str:
        """A sentence on effects that were not tried, as asked; "" without any."""
        if not self.without:
            return ""
        names = ", ".join(self.without)
        return f"Not tried, as asked: {names}. Known effects, as said here, are all others."


def read_request(
    recordings: File | Sequence[File],
    model: File,
    recording_map: File | None = None,
    *,
    also: str | type[Effect] | Sequence[str | type[Effect]] = (),
    without: str | Sequence[str] = (),
    effort: float = 1.0,
    trials: int = 0,
    sight: bool = True,
    check: Callable[[], None] = lambda: None,
) -> Request:
    """Read what a diagnosis needs, and say all that is wrong with it.

    Parameters
    ----------
    recordings : path or sequence of paths
    model, recording_map : path or str
        Files, or names of those that come with the program; without a map `find_map` looks for it.
    also : sequence of str or type
        Kinds, ``module:Class`` of a file beside the model, or classes.
    without, effort, trials, sight
        As in `Request`.
    check : callable
        Raises InvalidInput for what else would be in the way.

    Raises
    ------
    InvalidInput
        With all problems of all files and numbers.
    """
    if isinstance(recordings, str | os.PathLike):
        recordings = [recordings]
    also = [also] if isinstance(also, str | type) else also
    without = [without] if isinstance(without, str) else without
    files = tuple(os.fspath(file) for file in recordings)
    if not files:
        raise InvalidInput([Problem("RECORDING", "", "no file", "none", "at least one")])
    found = find_model(os.fspath(model))
    described = find_map(
        None if recording_map is None else os.fspath(recording_map), files[0], found
    )
    declared, kinds, recording, *_ = together(
        lambda: load(found),
        lambda: effects_named(also, found.parent),
        lambda: load_recording(list(files), described),
        lambda: _check_numbers(effort, trials),
        threads,
        check,
    )
    return Request(
        files, found, described, declared, recording, kinds, tuple(without), effort, trials, sight,
        digests(files, found, described), described.read_text(encoding="utf-8"),
    )  # fmt: skip


def effects_named(kinds: Sequence[str | type[Effect]], folder: Path) -> tuple[type[Effect], ...]:
    """Classes of effects by their kinds.

    Raises
    ------
    InvalidInput
        With every name that is none.
    """
    found: list[Any] = []
    problems = []
    for kind in kinds:
        if isinstance(kind, type):
            if _can_be_written(kind):
                found.append(kind)
            else:
                what = "a class that the corrected model could not name"
                right = "an Effect in a module of its own, at its top level"
                problems.append(Problem("--also", "", what, kind.__qualname__, right))
            continue
        try:
            found.append(find("effect", kind, folder))
        except UnknownKindError as error:
            problems.append(Problem("--also", "", error.what, kind, error.right))
    if problems:
        raise InvalidInput(problems)
    return tuple(found)


def _can_be_written(kind: type) -> bool:
    """Whether a model's file can name a class of effects: ``module:Class``."""
    named = kind.__module__ != "__main__" and "<locals>" not in kind.__qualname__
    return named and issubclass(kind, Effect)


def _check_numbers(effort: float, trials: int) -> None:
    problems = []
    if trials < 0:
        problems.append(Problem("--trials", "", "less than none", str(trials), "0 or more"))
    if not effort > 0.0:
        problems.append(Problem("--effort", "", "no effort", str(effort), "a number above 0"))
    if problems:
        raise InvalidInput(problems)
