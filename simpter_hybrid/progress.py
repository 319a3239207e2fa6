"""Progress of a long run on stderr, and its interruption at a place where nothing is lost."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType
from typing import Any, Self

#: Nothing is said before this much wall time has passed [s].
PATIENCE = 2.0
#: Wall time between two messages [s].
INTERVAL = 1.0
#: Wall time after which it is said that a search is still at work [s].
SILENCE = 30.0


def hears_signals() -> bool:
    """Whether this is the thread that hears signals: Python lets no other say what they do."""
    return threading.current_thread() is threading.main_thread()


def end_as_interrupted() -> None:
    """SIGTERM ends what is being written as Ctrl-C does: no half of a file is left."""
    if hears_signals():
        signal.signal(signal.SIGTERM, signal.default_int_handler)


class _Minding:
    """A context manager that minds Ctrl-C and SIGTERM, where they can be heard."""

    def __init__(self) -> None:
        self.interrupted = False
        self._before: dict[signal.Signals, Any] = {}

    def __enter__(self) -> Self:
        for number in (signal.SIGINT, signal.SIGTERM) if hears_signals() else ():
            self._before[number] = signal.signal(number, self._interrupt)
        return self

    def __exit__(self, *_: object) -> None:
        for number, handler in self._before.items():
            signal.signal(number, handler)

    def _interrupt(self, _number: int, _frame: FrameType | None) -> None:
        raise NotImplementedError


class Progress(_Minding):
    """Called by an engine with the instant reached; a context manager that minds Ctrl-C.

    The first Ctrl-C (or SIGTERM) ends the run where the record is whole; the second ends the
    program.
    """

    def __init__(self, t_end: float, quiet: bool = False) -> None:
        super().__init__()
        self.t_end, self.quiet = t_end, quiet
        self.began = self.said = time.monotonic()
        self.wrote = False
        #: When the first instant was reported: loading the program is no measure of its pace.
        self.first: float | None = None

    def __exit__(self, *_: object) -> None:
        super().__exit__()
        if self.wrote and sys.stderr.isatty():
            print(file=sys.stderr)

    def _interrupt(self, _number: int, _frame: FrameType | None) -> None:
        if self.interrupted:
            raise KeyboardInterrupt
        self.interrupted = True  # said when called: a handler may run within a write to stderr

    def __call__(self, t: float) -> None:
        """Say how far the run is; raise KeyboardInterrupt if it is to end."""
        if self.interrupted:
            print("\ninterrupted: keeping what there is", file=sys.stderr)
            raise KeyboardInterrupt
        now = time.monotonic()
        if self.first is None:
            self.first = now
        if t == 0.0 or self.quiet or now - self.began < PATIENCE or now - self.said < INTERVAL:
            return
        self.said, self.wrote = now, True
        line = progress_line(t, self.t_end, now - self.first)
        end = "\r" if sys.stderr.isatty() else "\n"
        print(f"{line:<60}", end=end, file=sys.stderr, flush=True)


class Murmur:
    """Says what it is told to say, and where that was long ago how much has been simulated since.

    Parameters
    ----------
    say : callable (text)
    """

    def __init__(self, say: Callable[[str], None]) -> None:
        self._say, self._last = say, time.monotonic()

    def __call__(self, text: str) -> None:
        """Say it."""
        self._last = time.monotonic()
        self._say(text)

    def simulated(self, steps: float) -> None:
        """Hear that so many steps were taken since the beginning."""
        if time.monotonic() - self._last > SILENCE:
            self(f"still at it: {steps / 1e6:.0f} million steps of simulated runs")


class Ending(_Minding):
    """Called to ask whether to end; a context manager in which the first Ctrl-C says to.

    So does SIGTERM; the second ends the program.
    """

    def __init__(self, said: str) -> None:
        super().__init__()
        self._said = said

    def _interrupt(self, _number: int, _frame: FrameType | None) -> None:
        if self.interrupted:
            raise KeyboardInterrupt
        self.interrupted = True
        with suppress(OSError):  # a handler may run within a write to stderr
            os.write(2, f"\n{self._said}\n".encode())

    def __call__(self) -> bool:
        return self.interrupted


class Interrupts(_Minding):
    """A context manager in which Ctrl-C and SIGTERM wait, until they are ``heard``.

    What must not be lost is written in it; what could be made again is written while they are
    heard.
    """

    def __init__(self) -> None:
        super().__init__()
        self._heard = False

    def _interrupt(self, _number: int, _frame: FrameType | None) -> None:
        self.interrupted = True
        if self._heard:
            self._heard = False  # one is enough: whatever is cleaned up after it is not cut short
            raise KeyboardInterrupt

    @contextmanager
    def heard(self) -> Iterator[None]:
        """Raise KeyboardInterrupt at an interrupt, and at once if one has been waiting."""
        self._heard = True
        try:
            if self.interrupted:
                raise KeyboardInterrupt
            yield
        except KeyboardInterrupt:
            self.interrupted = True
            raise
        finally:
            self._heard = False


def progress_line(t: float, t_end: float, spent: float) -> str:
    """``t = 1.2 s of at most 6 s, about 8 s left``; the wall time ``spent`` so far in seconds.

    Parameters
    ----------
    t, t_end : float
        Instant reached and longest duration, of the simulation [s].
    spent : float
        [s].
    """
    left = spent * (t_end - t) / t if t > 0.0 else None
    return f"t = {t:.3g} s of at most {t_end:g} s" + (
        f", about {duration(left)} left" if left is not None else ""
    )


def duration(seconds: float) -> str:
    """A wall time in the unit that suits it.

    Parameters
    ----------
    seconds : float
        [s].
    """
    if seconds < 90.0:
        return f"{seconds:.0f} s"
    return f"{seconds / 60.0:.0f} min" if seconds < 5400.0 else f"{seconds / 3600.0:.1f} h"
