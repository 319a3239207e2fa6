"""A sweep takes up results of the same measure alone: what it is bound to and its module count."""

import importlib
import sys
from functools import partial

import pytest

import simpter_hybrid as sh
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sweeps.measure_identity import measures_identity

LIMIT = 0.5
MODULE = "import scale_beside\nLIMIT = {}\ndef late(run):\n    return dict(late=LIMIT)\n"


TABLE = [1.0, 2.0]


def tabled(run):
    return {"x": TABLE[0]}


def scaled(run, k=1.0):
    return {"x": k * LIMIT}


def around(k):
    return lambda run: scaled(run, k)


class Scale:
    def __init__(self, k):
        self.k = k

    def __call__(self, run):
        return scaled(run, self.k)

    def of(self, run):
        return self(run)


@pytest.mark.parametrize(
    "made", [lambda k: partial(scaled, k=k), around, Scale, lambda k: Scale(k).of]
)
def test_what_it_is_bound_to_counts(made):
    assert measures_identity(made(1.0)) == measures_identity(made(1.0))
    assert measures_identity(made(1.0)) != measures_identity(made(1000.0))


def test_two_functions_without_a_name_are_two():
    one, two = lambda run: {"x": 1.0}, lambda run: {"x": 2.0}
    assert measures_identity(one) != measures_identity(two)


def test_a_constant_that_is_set_meanwhile_counts(monkeypatch):
    before = measures_identity(scaled)
    monkeypatch.setitem(globals(), "LIMIT", 1.5)
    assert measures_identity(scaled) != before


def test_another_text_of_its_module_or_of_one_beside_is_another(tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(tmp_path))
    for name in ("late_of_mine", "scale_beside"):
        monkeypatch.delitem(sys.modules, name, raising=False)
    found = []
    for limit, beside in ((0.5, "K = 1"), (15.5, "K = 1"), (0.5, "K = 1000"), (0.5, "K = 1")):
        (tmp_path / "scale_beside.py").write_text(beside)
        (tmp_path / "late_of_mine.py").write_text(MODULE.format(limit))
        found.append(measures_identity(importlib.import_module("late_of_mine").late))
    assert len(set(found)) == 3
    assert found[0] == found[3]


@pytest.mark.parametrize("bound", [object(), iter(())])
def test_what_cannot_be_told_is_refused(tmp_path, bound):
    with pytest.raises(InvalidInput, match=r"--measures: a measure bound to.*expected a function"):
        sh.sweep(
            "line-y24", {"run.t_end": ["1 ms"]}, tmp_path / "s", engine="reference",
            measures=partial(scaled, k=bound),
        )  # fmt: skip


def test_a_module_without_a_source_is_refused(tmp_path):
    made = {"__name__": "typed_in"}
    exec("def late(run): return {}", made)
    with pytest.raises(InvalidInput, match=r"source cannot be read.*typed_in:late"):
        sh.sweep(
            "line-y24", {"run.t_end": ["1 ms"]}, tmp_path / "s", engine="reference",
            measures=made["late"],
        )  # fmt: skip


def test_a_table_that_is_changed_meanwhile_counts(monkeypatch):
    before = measures_identity(tabled)
    monkeypatch.setitem(globals(), "TABLE", [3.0, 2.0])
    assert measures_identity(tabled) != before
