"""Which cases there are, and their order."""

import numpy as np
import pytest

from simpter_hybrid.problems import Problems
from simpter_hybrid.sweeps.axis import number_of, read_axis, split_values
from simpter_hybrid.sweeps.design import design, read_cases


def made(*texts, **more):
    problems = Problems("test")
    found = design([read_axis(text, problems) for text in texts], problems, **more)
    problems.raise_if_any()
    return found


def test_a_grid_runs_through_its_last_parameter_first():
    found = made("a=1,2", "b=x,y,z")
    assert found.paths == ("a", "b")
    assert found.rows == tuple((a, b) for a in "12" for b in "xyz")


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("a=0:0.6:4", ("0", "0.2", "0.4", "0.6")),
        ("a=1:3 lbf:3", ("1 lbf", "2 lbf", "3 lbf")),
        ("a=0:0.3:4 V/(lbf*in)", tuple(f"{k} V/(lbf*in)" for k in ("0", "0.1", "0.2", "0.3"))),
        ("a=1,2.5 lbf", ("1 lbf", "2.5 lbf")),
        ("a=1 N,2 lbf", ("1 N", "2 lbf")),
        ("a=x,2 lbf", ("x", "2 lbf")),
        ("a=1:100:3:log", ("1", "10", "100")),
        ('a=["1 in", "2 in"],["3 in", "4 in"]', ('["1 in", "2 in"]', '["3 in", "4 in"]')),
        ("a=../x.csv,../y.csv", ("../x.csv", "../y.csv")),
    ],
)
def test_forms_of_values(text, values):
    assert read_axis(text, Problems("test")).values == values


def test_commas_in_brackets_and_quotes_part_nothing():
    assert split_values('"a,b",[1,2],{x=1,y="]"},c') == ['"a,b"', "[1,2]", '{x=1,y="]"}', "c"]


@pytest.mark.parametrize("method", ["sobol", "lhs", "halton"])
def test_a_sample_is_the_same_for_one_seed_and_fills_the_interval(method):
    found = made("a=1..3 N", "b=0.01..1:log", sample=64, method=method, seed=7)
    assert found.rows == made("a=1..3 N", "b=0.01..1:log", sample=64, method=method, seed=7).rows
    assert found.rows != made("a=1..3 N", "b=0.01..1:log", sample=64, method=method, seed=8).rows
    a = np.array([number_of(row[0])[0] for row in found.rows])
    b = np.log([number_of(row[1])[0] for row in found.rows])
    # One point in each of 16 equal parts at least: far rarer missed by 64 such points than 1e-3.
    for x, low, high in ((a, 1.0, 3.0), (b, np.log(0.01), 0.0)):
        assert set(((x - low) / (high - low) * 16).astype(int)) == set(range(16))


def test_a_grid_times_a_list_times_a_sample(tmp_path):
    (tmp_path / "c.csv").write_text("p,q\n1,x\n\n2,y\n")
    problems = Problems("test")
    cases = read_cases(tmp_path / "c.csv", problems)
    found = made("a=1..2", "g=0,1", sample=3, cases=cases)
    assert found.paths == ("g", "p", "q", "a")
    assert len(found) == 2 * 2 * 3
    assert [row[:3] for row in found.rows[::3]] == [
        ("0", "1", "x"), ("0", "2", "y"), ("1", "1", "x"), ("1", "2", "y"),
    ]  # fmt: skip
    assert len({row[3] for row in found.rows}) == 3
