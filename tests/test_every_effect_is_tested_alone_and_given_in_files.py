"""No effect without a closed-form test; every one attached in a file is the one made in Python."""

import importlib.util
from pathlib import Path

import pytest
from effect_rig import BETWEEN, ELSEWHERE, all_effects, attached, pair, rig

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.reading.kinds import shipped

PAGE = Path(__file__).resolve().parent.parent / "docs" / "parts_page.py"


@pytest.fixture(scope="module")
def parts_page():
    spec = importlib.util.spec_from_file_location("parts_page", PAGE)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_effect_has_a_closed_form_or_a_limit(parts_page):
    # Add a test that names the class to a file whose name begins with one of parts_page.TESTS.
    without = [k for k, c in shipped("effect").items() if not parts_page.tests_of(k, c.__name__)]
    assert without == []


def test_every_effect_says_what_reveals_it():
    without = [k for k, cls in shipped("effect").items() if len(cls.reveals) < 20]
    assert without == []


def test_every_effect_is_on_a_rig_that_all_engines_run():
    known = {cls.__name__ for cls in all_effects()} | set(ELSEWHERE)
    assert {cls.__name__ for cls in shipped("effect").values()} == known


@pytest.mark.parametrize("effect", shipped("effect").values(), ids=lambda cls: cls.__name__)
def test_an_effect_in_a_file_is_the_one_that_was_written(effect):
    name = effect.__name__
    scenario = pair([BETWEEN[name]]) if name in ELSEWHERE else rig([attached(effect)])
    scenario = scenario.replace(loads=())
    again = parse(resolve(scenario).text)
    assert again.effects == scenario.effects
    assert again.parameter_values() == scenario.parameter_values()
