"""Dask: the same executor for one machine and for many."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Any

from ..problems import InvalidInput, Problem


@contextmanager
def dask_executor(address: str | None) -> Iterator[tuple[Executor | None, int]]:
    """An executor on the Dask scheduler at ``address`` and its number of threads; None without.

    Parameters
    ----------
    address : str or None
        E.g. ``tcp://127.0.0.1:8786``.

    Yields
    ------
    (Executor or None, int)
        Closed at the end of the ``with`` block.

    Raises
    ------
    InvalidInput
        If Dask is missing, no scheduler answers, or it has no workers.
    """
    if address is None:
        yield None, 0
        return
    right = "the address of a running scheduler, e.g. tcp://127.0.0.1:8786, or --jobs N"
    try:
        from distributed import Client

        client: Any = Client(address, timeout=10.0)
    except ImportError:
        right = "pip install 'dask[distributed]', or --jobs N"
        raise InvalidInput([_problem("dask is not installed", address, right)]) from None
    except (OSError, ValueError, TimeoutError) as error:
        what = f"no scheduler answers ({type(error).__name__})"
        raise InvalidInput([_problem(what, address, right)]) from None
    try:
        threads = sum(client.nthreads().values())
        if threads == 0:
            raise InvalidInput([_problem("the scheduler has no workers", address, "some workers")])
        # Not pure: a case tried again after its worker died must not be handed the old failure.
        yield client.get_executor(pure=False), threads
    finally:
        client.close()


def _problem(what: str, address: str, right: str) -> Problem:
    return Problem("--dask", "", what, address, right)
