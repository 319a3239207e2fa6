"""Watching a sweep: how far it is and what is left, and Ctrl-C where nothing is lost."""

from __future__ import annotations

import signal
import sys
import time
from types import FrameType
from typing import Any

from ..progress import INTERVAL, PATIENCE, duration, hears_signals
from .run import State


class Interruption:
    """A context in which the first Ctrl-C only sets ``came``; the second one ends the program."""

    def __init__(self) -> None:
        self.came = False
        self._before: Any = None

    def __enter__(self) -> Interruption:
        if hears_signals():
            self._before = signal.signal(signal.SIGINT, self._interrupt)
        return self

    def __exit__(self, *_: object) -> None:
        if self._before is not None:
            signal.signal(signal.SIGINT, self._before)

    def _interrupt(self, _number: int, _frame: FrameType | None) -> None:
        if self.came:
            raise KeyboardInterrupt
        self.came = True
        print("\ninterrupted: waiting for the cases at work", file=sys.stderr)


class Reporter:
    """Says on stderr how many cases are done; where that is no terminal only if asked to.

    Parameters
    ----------
    quiet : bool
    asked : bool
        Whether to speak where stderr is no terminal.
    """

    def __init__(self, quiet: bool = False, asked: bool = False) -> None:
        self.terminal = sys.stderr.isatty()
        self.silent = quiet or not (self.terminal or asked)
        self.began = self.said = time.monotonic()
        self.wrote = False

    def __call__(self, state: State) -> None:
        """Say it, if it is time to."""
        now = time.monotonic()
        if self.silent or now - self.began < PATIENCE or now - self.said < INTERVAL:
            return
        self.said, self.wrote = now, True
        line = state_line(state, now - self.began)
        print(f"{line:<70}", end="\r" if self.terminal else "\n", file=sys.stderr, flush=True)

    def end(self) -> None:
        """Leave the line that is written again and again."""
        if self.wrote and self.terminal:
            print(file=sys.stderr)


def state_line(state: State, spent: float) -> str:
    """``1200 of 10000 cases (800 were there), 3 failed, about 2 min left``; ``spent`` in s.

    Parameters
    ----------
    state : State
    spent : float
        [s].
    """
    line = f"{state.done} of {state.total} cases"
    line += f" ({state.found} were there)" if state.found else ""
    line += f", {state.failed} failed" if state.failed else ""
    new = state.done - state.found
    if new > 0:
        line += f", about {duration(spent * (state.total - state.done) / new)} left"
    return line
