"""A file says that there is none; one that says nothing is read with that stop, as ever."""

import pytest

import simpter_hybrid
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.stop import Singular, TipPassesX

LIMITS = [(), (TipPassesX(-0.7),), (Singular(),), (TipPassesX(-0.7), Singular(0.1))]


@pytest.fixture(scope="module")
def moved():
    return simpter_hybrid.load("reduced-clutch-1", ["run.t_end=5 ms"])


@pytest.mark.parametrize("stops", LIMITS)
def test_its_file_is_the_same_scenario(moved, stops):
    text = resolve(moved.replace(stops=stops)).text
    again = parse(text)
    assert again.stops == stops
    assert resolve(again).text == text


def test_a_saved_run_is_read_back(moved, tmp_path):
    run = simpter_hybrid.run(moved.replace(stops=()))
    assert simpter_hybrid.load_run(simpter_hybrid.save(run, tmp_path / "run")).t_end == run.t_end


def test_a_file_that_does_not_say_so_has_the_stop(moved):
    text = resolve(moved.replace(stops=())).text
    assert parse(text.replace("stops = []\n", "")).stops == (Singular(),)
    text = resolve(moved.replace(stops=(TipPassesX(-0.7),))).text
    without = text.replace("default_stops = false\n", "")
    assert parse(without).stops == (TipPassesX(-0.7), Singular())
