"""Worker processes of one machine: they end with the program that started them."""

from __future__ import annotations

import os
import signal
import threading
from collections.abc import Callable
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from multiprocessing import connection, parent_process
from typing import Any


def processes(jobs: int) -> Executor:
    """An executor of ``jobs`` processes; of this very process if it is one.

    Parameters
    ----------
    jobs : int
        1 or less: this process.
    """
    return ProcessPoolExecutor(jobs, initializer=begin) if jobs > 1 else InProcess()


def alone_process() -> Executor:
    """An executor of one process that is not this one."""
    return ProcessPoolExecutor(1, initializer=begin)


def begin() -> None:
    """In a new worker: leave Ctrl-C to the program that started it, and outlive it in no case."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = parent_process()
    if parent is not None:
        threading.Thread(target=_end_with, args=(parent.sentinel,), daemon=True).start()


def _end_with(sentinel: int) -> None:
    # A killed program closes nothing: its workers would wait for work for ever.
    connection.wait([sentinel])
    os._exit(1)


class InProcess(Executor):
    """Does the work at once, where it is submitted."""

    def submit(self, fn: Callable, /, *args: Any, **kwargs: Any) -> Future:
        """See ``Executor.submit``."""
        future: Future = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future
