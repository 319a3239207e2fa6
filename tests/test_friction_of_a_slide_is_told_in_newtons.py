"""Of a sliding axis the friction is a force: refusals, events and measures speak of N and m/s."""

import pytest
from sampled_runs import baseline

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.storage import events_csv
from simpter_hybrid.measuring.metrics import measures
from simpter_hybrid.problems import InvalidInput

SLIDE = """
[run]
t_end = "0.1 s"
[start]
coordinates = ["0 m"]
speeds = ["1 m/s"]
[device]
kind = "linear-axis"
mass = "2 kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "3 N", normal = "NORMAL" }
"""


def slide(normal):
    return parse(SLIDE.replace("NORMAL", normal), "slide.toml")


def test_a_friction_that_drives_is_refused_as_a_force():
    with pytest.raises(InvalidInput) as caught:
        slide("-1 N/V")
    (problem,) = [p for p in caught.value.problems if "negative" in p.what]
    assert problem.what == "the slip force is negative"
    assert "-7 N (-1.57366 lbf) at 10 V and 0 m/s" in problem.value
    assert problem.right.startswith("a slip force of at least 0")


def test_margins_and_measures_have_the_unit_of_the_device():
    for trajectory, unit, word in (
        (simulate(slide("0 N/V")), "N", "force"),
        (baseline(), "N m", "torque"),
    ):
        assert f",margin [{unit}]," in events_csv(trajectory).splitlines()[0]
        following = measures(trajectory).as_dict()["torque_following"]
        assert following["unit"] == unit
        assert following["label"] == f"rms of |{word}| less desired {word}, per clutch"
