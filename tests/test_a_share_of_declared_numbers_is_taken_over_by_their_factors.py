"""What a share of declared numbers does, the factors of these numbers do within tolerance."""

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.declared_off import off_by_a_share, scaled_numbers
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rotor.rig import RotorRig

DECLARED = load(find_model("testbed"))
MODEL = ScenarioPredictor(DECLARED, RotorRig())
SCALED = {"slip torque scale": 1.0, "breakaway torque scale": 1.02, "velocity slope": 0.9,
          "time constant": 1.1}  # fmt: skip


def _candidate(name, numbers):
    return off_by_a_share(name, numbers, (-0.9, 1.0, 0.02), 0.05, "family", "friction", (), "")


def _torques(predictor, values):
    """Slip torque at a speed, and breakaway torque, by the model's own law [N m]."""
    p, _ = predictor.vector(values)
    law, names = DECLARED.clutches[0].torque, predictor.runner.names
    own = {n: p[names[f"clutch.1.torque.{n}"]] for n in ("scale", *law.multiplied, "offset")}
    slope = p[names["clutch.1.torque.slope"]]
    slips = {n: own[n] for n in ("scale", "offset", "a", "b", "c")}
    breaks = {n: own[n] for n in ("scale", "d", "e", "f")}
    slip = law.slip_torque(speed=0.7, excitation=5.0, slope=slope, **slips)
    return np.array([slip, law.break_torque(excitation=5.0, **breaks)])


def test_within_tolerance_the_torques_are_the_same():
    scale = _candidate("torque-scale", scaled_numbers(DECLARED, *range(DECLARED.device.m)))
    values = {**SCALED, "torque-scale.share": 0.05}
    left = MODEL.absorbed(scale, values)
    assert left["breakaway torque scale"] == pytest.approx(1.02 * 1.05)
    with_share = _torques(MODEL.extended(scale), values)
    assert _torques(MODEL, left) == pytest.approx(
        with_share, rel=1e-12
    )  # products of a few numbers


def test_beyond_two_tolerances_it_is_a_finding():
    scale = _candidate("torque-scale", scaled_numbers(DECLARED, *range(DECLARED.device.m)))
    values = {**SCALED, "torque-scale.share": 0.07}  # breakaway 9 % off, good to 4 %
    assert MODEL.absorbed(scale, values) == values


def test_a_share_of_breakaway_leaves_sliding_alone():
    numbers = scaled_numbers(DECLARED, *range(DECLARED.device.m), breaking=True)
    left = MODEL.absorbed(_candidate("level", numbers), {**SCALED, "level.share": 0.05})
    assert left["breakaway torque scale"] == pytest.approx(1.02 * 1.05)
    assert {n: left[n] for n in SCALED if n != "breakaway torque scale"} == {
        n: v for n, v in SCALED.items() if n != "breakaway torque scale"
    }
