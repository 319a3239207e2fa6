"""One process or two, threads, chunks of any size, together or alone: the same files."""

from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor

import numpy as np
import pytest
from written_files import files

pytest.importorskip("llvmlite")
import simpter_hybrid as sh
from simpter_hybrid.compiled import simulate
from simpter_hybrid.measuring.metrics import measures
from simpter_hybrid.sweeps.batch import run_batch

NAME = "regulation-30hz-gain-0.25"
# Two structures (no lag is a model of its own), two ends of time, and numbers.
VARY = {
    "clutch.time_constant": ["0 s", "0.07 s"],
    "run.t_end": ["0.3 s", "0.5 s"],
    "controller.stages.2.gain": "0:0.2 V/(lbf*in):5",
}


@pytest.fixture(scope="module")
def one_by_one(tmp_path_factory):
    out = tmp_path_factory.mktemp("one") / "s"
    return sh.sweep(NAME, VARY, out, chunk=1), files(out)


@pytest.mark.parametrize("options", [{"chunk": 20}, {"jobs": 2, "chunk": 3}, {"chunk": 7}])
def test_the_same_files(tmp_path, one_by_one, options):
    sh.sweep(NAME, VARY, tmp_path / "s", **options)
    assert files(tmp_path / "s") == one_by_one[1]


@pytest.mark.parametrize("pool", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_on_an_executor_that_is_given(tmp_path, one_by_one, pool):
    with pool(2) as executor:
        sh.sweep(NAME, VARY, tmp_path / "s", executor=executor, jobs=2, chunk=3)
    assert files(tmp_path / "s") == one_by_one[1]


def test_runs_of_a_batch_are_single_runs_to_the_bit(one_by_one):
    table, _ = one_by_one
    given = [[f"{p}={v}" for p, v in r.given.items()] for r in table.records]
    scenarios = [sh.load(NAME, overrides) for overrides in given]
    for k, run, _ in run_batch(scenarios, 1e-3):
        single = simulate(scenarios[k])
        assert single.events == run.events
        assert np.array_equal(single.end, run.end)
        assert np.array_equal(single.step_f, run.step_f)
        assert table.records[k].measures["run_time"] == single.t_end


@pytest.mark.parametrize("engine", ["compiled", "reference"])
@pytest.mark.parametrize("name", ["line-y24-p016", "testbed-step-0-8"])
def test_measures_are_those_of_a_runs_summary(tmp_path, name, engine):
    vary = {"run.t_end": ["0.2 s"]}
    record = sh.sweep(name, vary, tmp_path / "s", engine=engine).records[0]
    expected = measures(sh.run(name, ["run.t_end=0.2 s"], engine=engine))
    for measure, value in record.measures.items():
        if measure == "events":
            continue
        stem, _, number = measure.partition(".")
        found = getattr(expected, stem)
        found = found[int(number) - 1] if number else found
        found = sum(found) if stem == "reversals" else found
        # NumPy's and Python's sines may differ in the last digit; jerk divides that by 1 ms.
        assert value == pytest.approx(found, rel=1e-11, abs=1e-9), measure
