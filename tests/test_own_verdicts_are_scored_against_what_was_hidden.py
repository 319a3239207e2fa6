"""The score of a diagnosis of an own recording, and which cases a subset holds."""

import importlib
import sys
from pathlib import Path

import pytest

BENCHMARKS = Path(__file__).resolve().parent.parent / "benchmarks"


@pytest.fixture
def own(monkeypatch):
    monkeypatch.setitem(sys.modules, "numba", None)
    monkeypatch.syspath_prepend(str(BENCHMARKS))
    before = set(sys.modules)
    yield {n: importlib.import_module(f"own_{n}") for n in ("cases", "score", "table")}
    for name in set(sys.modules) - before:
        if name.startswith("own_"):
            del sys.modules[name]


def verdict(hides, kind, effects=(), others=(), depends=()):
    return {
        "hides": dict.fromkeys(hides, 1.0),
        "verdict": kind,
        "effects": list(effects),
        "cannot_exclude": list(others),
        "depends_on": list(depends),
    }


@pytest.mark.parametrize(
    ("row", "expected"),
    [
        (verdict([], "nothing missing"), "right"),
        (verdict([], "effect", ["drift"]), "named"),
        (verdict(["asymmetry"], "effect", ["asymmetry"]), "right"),
        (verdict(["asymmetry"], "effect", ["asymmetry", "drift"]), "spurious"),
        (verdict(["asymmetry"], "form incomplete", ["drift"]), "misnamed"),
        (verdict(["asymmetry"], "nothing missing"), "missed"),
        (verdict(["asymmetry"], "cannot be told apart", ["drift"], ["asymmetry"]), "set with it"),
        (verdict(["asymmetry"], "cannot be told apart", ["drift"]), "set without it"),
        (verdict(["asymmetry", "drift"], "effect", ["drift"]), "part"),
        (verdict(["squeal"], "effect", ["stribeck"]), "named"),
        (verdict(["backlash"], "unknown", depends=["friction:time"]), "unknown"),
        (verdict(["poles-by-command"], "unknown", depends=["friction:position"]), "right"),
    ],
)
def test_a_verdict_is_scored(own, row, expected):
    assert own["score"].score(row) == expected


def test_every_case_has_a_name_and_a_seed_of_its_own(own):
    every = own["cases"].cases()
    drawn = [c for c in every if c.group not in ("without", "advised")]
    assert len({c.name for c in every}) == len(every)
    assert len({c.seed for c in drawn}) == len(drawn)
    assert sum(c.group == "null" for c in every) == 200
    assert sum(c.noise == "coloured" for c in every if c.group == "null") == 100


@pytest.mark.parametrize(
    ("name", "like"),
    [
        ("without.stribeck@1.coloured.1", "stribeck@1.coloured.1"),
        ("advised.wear-in@1.white.1", "poor.wear-in@1.white.1"),
    ],
)
def test_what_is_asked_twice_of_a_recording_has_one_seed(own, name, like):
    seeds = {c.name: c.seed for c in own["cases"].cases()}
    assert seeds[name] == seeds[like]


def test_a_table_of_rows_counts_them_where_they_belong(own):
    common = {"noise": "white", "refitted": 2.0, "after": 1.01, "floor": 1.0, "values": {},
              "cpu_seconds": 1.0, "commit": "x", "code": "y"}  # fmt: skip
    rows = [
        {**common, **verdict([], "nothing missing"), "case": "null.white.1", "group": "null"},
        {**common, **verdict(["drift"], "effect", ["drift"]), "case": "drift", "group": "single"},
    ]
    assert own["table"].confusion(rows) == (
        ["nothing", "drift"], ["drift", "nothing missing"], [[0, 1], [1, 0]],
    )  # fmt: skip
