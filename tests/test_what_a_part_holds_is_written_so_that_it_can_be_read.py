"""A scenario made in Python, written out and read again: steps in tables, whole numbers, limits."""

import math

import numpy as np
import pytest
from devices_for_tests import always_on

from simpter_hybrid.api import load_run, save
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.profile import CommandProfile
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.files.scenario_text import LONGEST_TABLE, resolve
from simpter_hybrid.laws import CoulombViscous
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario


def axis(**more) -> Scenario:
    """A mass with a clutch, for a tenth of a second."""
    given = {"device": LinearAxis(mass=1.0), "clutches": (Clutch(CoulombViscous(coulomb=1.0)),)}
    return Scenario(name="axis", q=(0.0,), qd=(1.0,), t_end=0.1, **(given | more))


@pytest.mark.parametrize("steps", [2, LONGEST_TABLE])
def test_a_table_with_steps(steps, tmp_path):
    points = [(0.01 * k, float(v % 3)) for k in range(steps) for v in (k, k + 1)]
    run = axis(controllers=((CommandProfile(points=tuple(points)), 1),), period=0.01)
    save(simulate(run), tmp_path / "run")
    again = load(tmp_path / "run" / "scenario.toml")
    assert again.controllers == run.controllers


def test_a_whole_number_keeps_its_unit(tmp_path):
    run = axis(
        device=LinearAxis(mass=1),
        clutches=(Clutch(CoulombViscous(coulomb=1), time_constant=0, delay=0),),
    )
    first = simulate(run)
    again = load_run(save(first, tmp_path / "run"))
    assert again.scenario.device.mass == 1.0
    assert (again.end == first.end).all()


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"max_step": math.inf}, "finite"),
        ({"event_limit": 1e5}, "whole number"),
        ({"event_limit": True}, "whole number"),
    ],
)
def test_what_could_not_be_read_again_is_refused(wrong, told):
    run = axis(clutches=(always_on(1.0, 1.0),))
    validate(run)
    with pytest.raises(InvalidInput, match=told):
        validate(run.replace(**wrong))


def test_a_whole_number_of_numpy_is_one():
    run = axis(clutches=(always_on(1.0, 1.0),)).replace(event_limit=np.int64(500))
    assert parse(resolve(run).text).event_limit == 500
