"""A sweep from request to table."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Executor, Future
from dataclasses import dataclass
from typing import Any

from .case import Record, record_of
from .execution import Crew, Part, on_executor, on_processes
from .plan import Plan
from .table import Table, table_csv, table_json
from .work import run_cases

#: Cases a chunk, where one call of the compiled engine runs them all, and where it does not.
BATCH, FEW, SINGLE = 32, 4, 1


@dataclass
class State:
    """How far a sweep is.

    Parameters
    ----------
    total, found : int
        Cases (equal ones counted once), and those whose results were there at the start.
    done, failed : int
        Cases whose results are there now, and those of them that failed.
    """

    total: int
    found: int
    done: int
    failed: int


class Interrupted(KeyboardInterrupt):
    """A sweep that was ended before all cases were done; what is done is kept."""

    def __init__(self, state: State) -> None:
        super().__init__(f"{state.done} of {state.total} cases are done and kept")
        self.state = state


@dataclass
class Sweep:
    """A sweep at work: ``Sweep(make_plan(request)).work()``.

    Parameters
    ----------
    plan : Plan
    executor : Executor, optional
        Any of ``concurrent.futures`` or Dask's; else ``plan.jobs`` processes of this machine.
    report : callable, optional
        Called with the State as results come.
    stop : callable, optional
        Whether to end before all is done.
    """

    plan: Plan
    executor: Executor | None = None
    report: Callable[[State], Any] | None = None
    stop: Callable[[], bool] = lambda: False

    def work(self) -> Table:
        """Run the cases that are not there yet, and make the table of all.

        Raises
        ------
        Interrupted
            If ``stop`` said so; the same request goes on.
        InvalidInput
            If another process is at work on this sweep.
        """
        directory = self.plan.directory
        directory.open(self.plan.files)
        try:
            records = self._records()
            ordered = tuple(records[case.name] for case in self.plan.cases)
            table = Table(self.plan.design, ordered, self.plan.scenario.device)
            write_tables(self.plan, table)
        finally:
            directory.close()
        return table

    def _records(self) -> dict[str, Record]:
        """The records of all cases by name."""
        plan, directory = self.plan, self.plan.directory
        wanted = {case.name: case for case in plan.cases}
        records = directory.read(list(wanted))
        left = [case for name, case in wanted.items() if name not in records]
        bad = sum(not record.good for record in records.values())
        state = State(len(wanted), len(records), len(records), bad)

        def take(results: Sequence[tuple[str, bytes]]) -> None:
            directory.write(results)
            for name, content in results:
                record = record_of(content)
                assert record is not None
                records[name] = record
                state.failed += not record.good
            state.done = len(records)
            if self.report is not None:
                self.report(state)

        def submit(executor: Executor, part: Part) -> Future:
            return executor.submit(run_cases, plan.base, plan.options, part)

        crew = Crew(submit, take, self.stop, plan.jobs)
        size = plan.chunk or chunk_size(plan, len(left), plan.jobs)
        if self.executor is not None:
            on_executor(self.executor, crew, left, size)
        else:
            on_processes(crew, left, size)
        if len(records) < len(wanted):
            raise Interrupted(state)
        return records


def chunk_size(plan: Plan, count: int, jobs: int) -> int:
    """Cases a chunk: enough for one call, few enough for everybody to have some.

    Parameters
    ----------
    plan : Plan
    count : int
        Cases to be run.
    jobs : int
        Workers.
    """
    if plan.options.engine == "reference":
        return SINGLE
    most = BATCH if plan.options.measures == "brief" else FEW
    return max(1, min(most, count // (4 * jobs)))


def write_tables(plan: Plan, table: Table) -> None:
    """The table as CSV and JSON, and Sobol indices where the design was made for them.

    Parameters
    ----------
    plan : Plan
        Its directory is written to.
    table : Table
    """
    from .results import write_whole

    write_whole(plan.directory.path / "table.csv", table_csv(table).encode())
    write_whole(plan.directory.path / "table.json", table_json(table).encode())
    if plan.design.saltelli:
        from .indices import indices_json

        write_whole(plan.directory.path / "sobol.json", indices_json(table).encode())
