"""Machine code hears of an interrupt within a step; what it leaves is the beginning of the run."""

import signal
from threading import Timer

import numpy as np
import pytest

pytest.importorskip("llvmlite")
from simpter_hybrid.compiled import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.machine_code.attended import attended
from simpter_hybrid.progress import Progress

#: Some hundred thousand steps, which take a second or more.
LONG = load("line-y24", ['run.max_step="20 us"'])


class Struck(Progress):
    """Ctrl-C when the run has come some way."""

    def __call__(self, t):
        if t > 0.01 and not self.interrupted:
            signal.raise_signal(signal.SIGINT)
        super().__call__(t)


def test_what_there_was_is_kept(capsys):
    with Struck(LONG.t_end, quiet=True) as progress:
        found = simulate(LONG, progress)
    assert found.status == "interrupted"
    assert found.message == f"interrupted at t = {found.t_end!r} s"
    whole = simulate(LONG)
    count = len(found.step_t)
    assert 0 < count < len(whole.step_t)
    assert np.array_equal(found.step_y, whole.step_y[:count])
    assert np.array_equal(found.end, whole.step_y[count])
    assert found.t_end == whole.step_t[count]


def test_without_anybody_who_asks_how_far_it_is_it_ends_what_runs_one_after_another():
    before = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in the background
    Timer(0.3, signal.raise_signal, [signal.SIGINT]).start()
    try:
        with pytest.raises(KeyboardInterrupt):
            [simulate(LONG).t_end for _ in range(20)]
    finally:
        signal.signal(signal.SIGINT, before)


def test_an_error_of_what_runs_in_a_thread_is_heard():
    def work():
        raise MemoryError

    with pytest.raises(MemoryError):
        attended(work, lambda: None, lambda: None)


def test_an_error_while_it_is_told_how_far_the_run_is_is_not_hidden():
    def broken(t):
        raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        simulate(LONG, broken)
