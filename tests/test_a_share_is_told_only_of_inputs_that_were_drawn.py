"""``reproduce``: the share beside a verdict is that of drawn inputs for which the claim holds."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.reproduce import baseline, tables, tracking, variants
from simpter_hybrid.reproduce.standard import CONTROLLERS


def test_nominal_runs_alone_have_no_share(monkeypatch):
    found = iter([(1.0, 2.0, 3), (1.0, 1.0, 3)] * 2 + [(1.0, 1.0, 3), (1.0, 2.0, 3)])
    monkeypatch.setattr(variants, "summary", lambda run: next(found))
    row = variants.materials(lambda scenario: None)
    assert (row.verdict, row.share) == ("does not hold", None)
    assert "2 of 3 controllers" in row.ours


def test_fixed_combinations_have_no_share(monkeypatch):
    found = iter([(2.0, 0.0, 0.0), (1.0, 0.0, 0.0), (3.0, 20.0, 0.0)] * 6)
    monkeypatch.setattr(tracking, "tracked", lambda *given: None)
    monkeypatch.setattr(tracking, "following", lambda run: next(found))
    row = tracking.sensitivity(lambda scenario: None)
    assert (row.verdict, row.share) == ("holds", None)
    assert row.ours.startswith("6 of 6 combinations")


def test_the_share_of_a_count_is_that_of_the_count(monkeypatch):
    drawn = [(0, 2, 4, 0), (0, 2, 3, 0), (0, 1, 1, 0), (1, 2, 3, 0)]
    runs = [
        {"baseline": SimpleNamespace(finished=True, flat_portions=f, transitions=sum(f))}
        for f in drawn
    ]
    monkeypatch.setattr(baseline, "plausible", lambda engine, draws: runs)
    counted = SimpleNamespace(counts=(0, 2, 4, 0), total=6, reversals=(0, 0, 0, 0))
    row = baseline.flat(lambda scenario: None, counted, 4)[0]
    assert (row.verdict, row.share) == ("holds", 0.25)


def test_a_run_that_must_arrive_with_each_controller_arrives_with_all(monkeypatch):
    runs = [
        {name: SimpleNamespace(finished=name != late) for name in CONTROLLERS}
        for late in ("baseline", "P", "none")
    ]
    monkeypatch.setattr(tables, "plausible", lambda engine, draws: runs)
    nominal = {name: SimpleNamespace(run_time=5.0) for name in CONTROLLERS}
    monkeypatch.setattr(tables, "table", lambda engine: nominal)
    row = tables.reach(lambda scenario: None, 3)
    assert row.share == pytest.approx(1 / 3)
    nominal["P"].run_time = 12.0
    row = tables.reach(lambda scenario: None, 3)
    assert row.verdict == "does not hold"
    assert row.ours.startswith("nominal: no, not with impedance with feedback 0.16;")
