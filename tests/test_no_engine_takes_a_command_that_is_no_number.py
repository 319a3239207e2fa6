"""A command that is not finite is above no threshold: unnoticed, it would switch its clutch off."""

import math
from dataclasses import dataclass
from functools import partial

import pytest
from devices_for_tests import Coulomb

from simpter_hybrid import compiled, engine, karnopp, regularised
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controller import Controller
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.scenario import Scenario

ENGINES = {
    "reference": engine.simulate,
    "compiled": compiled.simulate,
    "karnopp": partial(karnopp.simulate, max_step=0.02),
    "smooth": regularised.simulate,
}
VALUES = {"nan": math.nan, "inf": math.inf, "-inf": -math.inf}


@dataclass(frozen=True)
class LosesItsNumber(Controller):
    before: float
    after: float

    @staticmethod
    def step(k, held, before, after):
        held[0] = after if k >= 5 else before


def run(name, after, before=1.0, **clutch):
    clutches = (Clutch(Coulomb(1.0, 1.0), **clutch),)
    s = Scenario("lost", Testbed(1.0), clutches, (0.0,), (2.0,), 0.3, command=(before,))
    return ENGINES[name](s.replace(controllers=((LosesItsNumber(before, after), 1),), period=0.01))


@pytest.mark.parametrize("name", ENGINES)
@pytest.mark.parametrize("value", VALUES)
def test_the_run_fails_at_the_sample(name, value):
    found = run(name, VALUES[value])
    told = value if name != "karnopp" else "not a finite number"
    said = f"at the sample at t = 0.05 s the command of clutch 1 is {told}"
    source = "" if name == "karnopp" else "; it came from controller 1, step"
    assert (found.status, found.message) == ("failed", said + source)


@pytest.mark.parametrize("name", ENGINES)
@pytest.mark.parametrize("clutch", [{"time_constant": 0.07}, {"threshold": 2.0}])
def test_also_with_a_lag_and_of_a_clutch_that_is_off(name, clutch):
    found = run(name, math.nan, **clutch)
    assert found.status == "failed"
    assert "at t = 0.05 s the command of clutch 1" in found.message


def test_the_compiled_engine_names_no_controller_where_it_cannot_know():
    s = Scenario("two", Testbed(1.0), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (2.0,), 0.3)
    stages = ((LosesItsNumber(1.0, 1.0), 1), (LosesItsNumber(1.0, math.nan), 1))
    said = compiled.simulate(s.replace(controllers=stages, period=0.01)).message
    assert said.endswith("is nan; the engine 'reference' names the controller that it came from")
