"""``method`` under ``[run]``: of the run, of its resolved form, of its files."""

import numpy as np
import pytest

from simpter_hybrid import engine, load
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.files import storage
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput

SHORT = ["run.t_end=0.2 s"]


@pytest.mark.parametrize(("told", "method"), [([], "DOP853"), (["run.method=RK45"], "RK45")])
def test_in_the_resolved_form_which_leaves_nothing_to_a_default(told, method):
    text = resolve(load("line-y24", told)).text
    assert f'method = "{method}"' in text
    assert parse(text).method == method


def test_a_run_is_read_back_to_the_bit(tmp_path):
    scenario = load("line-y24", [*SHORT, "run.method=RK45"])
    run = engine.simulate(scenario)
    assert run.step_f.shape[1] == 4
    again = storage.load(storage.save(run, tmp_path / "run", resolve(scenario).text))
    assert again.scenario.method == "RK45"
    assert np.array_equal(again.step_f, run.step_f)
    assert np.array_equal(again.state(0.1234), run.state(0.1234))


def test_a_scenario_made_in_python_is_told_of_a_wrong_one():
    with pytest.raises(InvalidInput, match=r"run\.method: .*\"Euler\".* one of DOP853, RK45"):
        validate(load("line-y24").replace(method="Euler"))
