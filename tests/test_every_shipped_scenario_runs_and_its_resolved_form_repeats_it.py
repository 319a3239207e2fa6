"""Shipped scenarios load, check, run, with either engine; their resolved form gives the same."""

import pytest
from same_runs import assert_same

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import UNITS, load, parse, shipped_scenarios
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.files.storage import events_csv, trajectory_bytes
from simpter_hybrid.measuring.energy import energy_balance

NAMES = list(shipped_scenarios())


def test_the_ten_are_there():
    tested = [f"reduced-clutch-{i}" for i in (1, 2, 3, 4)]
    locked = ["1-locked-2", "2-locked-1", "3-locked-4", "4-locked-3"]
    expected = {"line-y24", "line-y24-30hz", *tested, *(f"reduced-clutch-{k}" for k in locked)}
    assert expected <= set(NAMES)


@pytest.mark.parametrize("name", NAMES)
def test_it_runs_and_its_resolved_form_reproduces_the_bytes(name):
    pytest.importorskip("llvmlite")
    from simpter_hybrid.compiled import simulate as compiled

    scenario = load(name)
    resolved = resolve(scenario)
    again = parse(resolved.text)
    assert resolve(again) == resolved

    reference, first, second = simulate(scenario), compiled(scenario), compiled(again)

    assert reference.status in ("finished", "stopped")
    assert energy_balance(reference).relative < 1e-8  # what every shipped scenario promises
    assert_same(reference, first)
    assert trajectory_bytes(first) == trajectory_bytes(second)
    assert events_csv(first) == events_csv(second)


@pytest.mark.parametrize("name", NAMES)
def test_it_says_what_it_answers_to(name):
    notes = load(name).notes
    assert notes["about"]
    assert "thesis" in notes["answers_to"]
    assert "# " in shipped_scenarios()[name].read_text()


def test_at_30_hz_only_the_rate_differs():
    slow, same = load("line-y24-30hz"), load("line-y24", ["controller.rate=30 Hz"])
    rename = {"name": "", "notes": {}}
    assert slow.replace(**rename) == same.replace(**rename)


@pytest.mark.parametrize(("tested", "locked"), [(1, 2), (2, 1), (3, 4), (4, 3)])
def test_a_locked_clutch_is_all_that_differs(tested, locked):
    alone = load(f"reduced-clutch-{tested}")
    both = load(f"reduced-clutch-{tested}-locked-{locked}")
    signal = list(alone.command)
    signal[locked - 1] = 10.0
    same = {"name": "", "notes": {}, "command": tuple(signal), "excitation": tuple(signal)}
    assert both.command == tuple(signal)
    assert alone.replace(**same) == both.replace(**same)


def test_units_of_reports_are_those_that_pictures_know():
    from simpter_hybrid.plots import DISPLAYS

    assert set(UNITS) == set(DISPLAYS)
