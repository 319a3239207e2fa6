"""Where friction alone acts only its ratio to the inertia shows: it is friction that differs."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.bench import _weighed_once
from simpter_hybrid.identification.channel_factors import factors_of_quantity
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.runwise_search import _asked
from simpter_hybrid.loads.ramp import RampOnCoordinate

SLIDE = """
[run]
t_end = "1 s"
[start]
coordinates = ["0 m"]
[device]
kind = "linear-axis"
mass = "2 kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "1 N" }
[[tolerances]]
name = "weight"
parameters = ["device.mass"]
relative = 0.02
"""
FRICTION = """
[[tolerances]]
name = "friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.5
"""
PUSH = RampOnCoordinate(0.0, 1.0, 0.0)


@pytest.mark.parametrize(
    ("text", "loads", "common"),
    [(SLIDE + FRICTION, (), ("weight",)), (SLIDE, (), ()), (SLIDE + FRICTION, (PUSH,), ())],
    ids=["friction alone", "nothing else declared", "a load"],
)
def test_an_inertia_is_the_same_where_friction_alone_acts(text, loads, common):
    assert _weighed_once(parse(text).replace(loads=loads)) == common


def test_of_what_is_common_it_is_not_asked():
    names = ("weight", "friction")
    known = [Parameter(n, 1.0, 0.5, 1.5, 0.01, tolerance=0.1) for n in names]
    fitted = Parameter("drag", 0.0, -1.0, 1.0, 0.01)
    model = SimpleNamespace(predictor=SimpleNamespace(parameters=[*known, fitted]))
    assert _asked(model, ("weight",)) == ["friction"]
    assert _asked(model, ()) == [*names]


@pytest.mark.parametrize(("unit", "asked"), [("km/h", True), ("m/s", True), ("rad/s", False)])
def test_of_a_speed_along_a_way_kilometres_an_hour_are_asked(unit, asked):
    channels = {"speed": SimpleNamespace(unit=unit, summed=False)}
    factors = factors_of_quantity(SimpleNamespace(channels=channels, runs=[]), ("speed",))
    assert any(f == pytest.approx(3.6) for f in factors) is asked
    assert any(f == pytest.approx(1 / 3.6) for f in factors) is asked
