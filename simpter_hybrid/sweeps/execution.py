"""Work handed out in chunks and taken back as it comes, on any executor."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, Executor, Future, wait
from dataclasses import dataclass

from .case import Record
from .processes import alone_process, processes
from .work import Case

#: Chunks handed out beyond those at work, so that nobody waits.
AHEAD = 2
#: How often a case may take its process with it before it is recorded as what kills processes.
DEATHS = 2

Part = Sequence[Case]


@dataclass(frozen=True)
class Crew:
    """How work is done.

    Parameters
    ----------
    submit : callable
        ``submit(executor, cases)`` returns the future of their results.
    take : callable
        Called with results as they come, ``(name, content)``, and now and then with none.
    stop : callable
        Whether to end: what is at work is then taken, nothing more is begun.
    jobs : int
        Workers.
    """

    submit: Callable[[Executor, Part], Future]
    take: Callable[[Sequence[tuple[str, bytes]]], None]
    stop: Callable[[], bool]
    jobs: int


def chunks(cases: Part, size: int) -> list[Part]:
    """The cases in parts of ``size``.

    Parameters
    ----------
    cases : sequence of Case
    size : int
        1 or more; the last part may be smaller.
    """
    return [cases[k : k + size] for k in range(0, len(cases), size)]


def hand_out(
    executor: Executor, crew: Crew, parts: Iterable[Part]
) -> tuple[list[Part], list[Part]]:
    """Hand out parts and take their results until all are done.

    Parameters
    ----------
    executor : Executor
    crew : Crew
    parts : iterable of sequences of Case

    Returns
    -------
    lost, left : list
        Parts that were at work when a worker died; parts that were not begun because the executor
        broke at that.
    """
    waiting = deque(parts)
    at_work: dict[Future, Part] = {}
    gone: list[Part] = []
    broken = False
    while waiting or at_work:
        while waiting and not broken and len(at_work) < crew.jobs + AHEAD:
            try:
                future = crew.submit(executor, waiting[0])
            except BrokenExecutor:
                broken = True
                break
            at_work[future] = waiting.popleft()
            if future.done():  # an executor that works where it is asked to
                break
        if broken and not at_work:
            return gone, list(waiting)
        done, _ = wait(at_work, timeout=1.0, return_when=FIRST_COMPLETED)
        for future in done:
            part = at_work.pop(future)
            if future.cancelled():
                continue
            if worker_died(future):
                gone.append(part)
                broken = broken or isinstance(future.exception(), BrokenExecutor)
            else:
                crew.take(future.result())
        if not done:
            crew.take(())
        if crew.stop():
            waiting.clear()
            for future in at_work:
                future.cancel()
    return gone, []


def worker_died(future: Future) -> bool:
    """Whether what failed is the worker, not the work; Dask has an error of its own for that.

    Parameters
    ----------
    future : Future
        Done, and not cancelled.
    """
    error = future.exception()
    return isinstance(error, BrokenExecutor) or type(error).__name__ == "KilledWorker"


def on_processes(crew: Crew, cases: Part, size: int) -> None:
    """Work on processes of this machine, and go on when one of them dies.

    What was at work then is repeated case by case, each alone.

    Parameters
    ----------
    crew : Crew
    cases : sequence of Case
    size : int
        Cases handed out at a time.
    """
    parts = chunks(cases, size)
    while parts and not crew.stop():
        with processes(crew.jobs) as executor:
            gone, parts = hand_out(executor, crew, parts)
        for case in (case for part in gone for case in part):
            alone(crew, case)


def alone(crew: Crew, case: Case) -> None:
    """One case in a process of its own; one whose process dies twice is recorded as such.

    Parameters
    ----------
    crew : Crew
    case : Case
    """
    for _ in range(DEATHS):
        if crew.stop():
            return
        with alone_process() as executor:
            if hand_out(executor, crew, [[case]]) == ([], []):
                return
    crew.take([killed(case)])


def on_executor(executor: Executor, crew: Crew, cases: Part, size: int) -> None:
    """Work on an executor that somebody else minds, once more where its workers died.

    Parameters
    ----------
    executor : Executor
    crew, cases, size
        As for `on_processes`.

    Raises
    ------
    BrokenExecutor
        If it can do no more work.
    """
    gone, left = hand_out(executor, crew, chunks(cases, size))
    if not left and gone:
        gone, left = hand_out(executor, crew, [[case] for part in gone for case in part])
    if left:
        raise BrokenExecutor("the executor can do no more work; what is finished is kept")
    for case in (case for part in gone for case in part):
        crew.take([killed(case)])


def killed(case: Case) -> tuple[str, bytes]:
    """The result of a case that takes its process with it.

    Parameters
    ----------
    case : Case

    Returns
    -------
    (str, bytes)
        Name and content of its file.
    """
    message = "its worker process died again and again, running nothing else"
    return case.name, Record(case.name, dict(case.given), "killed", message, None, {}).to_bytes()
