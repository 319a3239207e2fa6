"""A friction that changes in a run, or the gain of the one sensor that shows it."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.reporting.dependence_text import depends_on
from simpter_hybrid.identification.reporting.meaning import meaning
from simpter_hybrid.identification.reporting.sentences import or_sensor_sentence
from simpter_hybrid.identification.rotor.candidates import rotor_candidates
from simpter_hybrid.identification.tracing.signature import Dependence

SEEN = Dependence("time", 0.1, 0.005, 5000, *3 * [np.zeros(1)])
#: The balances of a rotor: where the motor's torque was not recorded that of it shows nothing.
BOTH, ONE = {"friction": (SEEN,), "load": (SEEN,)}, {"friction": (SEEN,), "load": ()}


@pytest.mark.parametrize(
    ("name", "balances", "told"),
    [
        ("drift", ONE, True), ("thermal-fade", ONE, True),
        ("drift", BOTH, False), ("stribeck", ONE, False), ("added-inertia", ONE, False),
    ],
)  # fmt: skip
def test_of_one_torque_what_grows_in_a_run_may_be_the_sensor(name, balances, told):
    named = [c for c in rotor_candidates() if c.name == name]
    nothing_left = Some(coordinates=())
    done = Some(corrected=Some(effects=named), rounds=[Some(before=balances)], verdict=nothing_left)
    said = or_sensor_sentence(Some(search=done))
    assert said.startswith(f"One torque alone does not tell {name} from a sensor") is told
    assert bool(said) is told


@pytest.mark.parametrize(
    ("name", "gain", "balances", "told"),
    [
        ("sensor gain", -0.012, BOTH, True), ("motor sensor gain", 0.012, BOTH, True),
        # A bearing takes from the motor's torque, and never adds to it.
        ("sensor gain", 0.012, BOTH, False), ("motor sensor gain", -0.012, BOTH, False),
        ("sensor gain", -0.012, ONE, False), ("sensor lag", 0.012, BOTH, False),
    ],
)  # fmt: skip
def test_of_two_torques_a_gain_may_be_a_bearing_beside_the_clutch(name, gain, balances, told):
    named = [c for c in rotor_candidates() if c.name == name]
    model = Some(effects=named, values={f"{name}.gain": gain})
    done = Some(corrected=model, rounds=[Some(before=balances)], verdict=Some(coordinates=()))
    said = or_sensor_sentence(Some(search=done))
    assert (f"(by 1.2 % of it) would look the same as {name}" in said) is told
    assert ("not of the machine" in meaning(named[0])) is (name == "sensor lag")


def test_what_leads_in_both_balances_is_of_the_sensor_too():
    both = depends_on(["load:time", "load:torque", "friction:time"])
    assert both.endswith("(both have the torque sensor in common, and time)")
    levels = depends_on(["friction:time", "load:torque", "load:time", "breakaway:rest"])
    assert "in common, and time); rest (the level of breakaway)" in levels
    assert "in common" not in depends_on(["load:torque", "friction:time"])
    assert "in common" not in depends_on(["load:position", "friction:position"])


def test_sizes_are_those_that_are_fitted():
    for one in rotor_candidates():
        assert {*one.sizes} <= {p.name for p in one.parameters}
    sizes = {c.name: c.sizes for c in rotor_candidates()}
    assert sizes["asymmetry"] == ("asymmetry.share",)
    assert sizes["position-friction"] == tuple(
        f"position-friction.once_{wave}" for wave in ("cos", "sin")
    )
