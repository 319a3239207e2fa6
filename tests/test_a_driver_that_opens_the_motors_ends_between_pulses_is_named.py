"""Pulses at whose ends a motor coasts: its back-EMF acts for their part of the time alone."""

from math import exp

import numpy as np
import pytest
from axis_recordings import written
from devices_for_tests import Coulomb
from motor_by_voltage import FRICTION, MAP, MODEL, SUPPLY, J, K, R

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.axis_servo import PositionServo
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.loads.drive import VoltageDrive
from simpter_hybrid.scenario import Scenario


def stairs(folder, coasting):
    """Three takes of duties in steps, each a closed form: an exponential towards its own speed."""
    generator, step, rows = np.random.default_rng(3), 0.01, ["take,s,rate,duty,supply"]
    for take in range(3):
        duties = np.repeat(generator.permutation([0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]), 30)
        speed = 40.0
        for k, duty in enumerate(duties):
            seen = speed + generator.normal(0.0, 0.2)
            rows.append(f"{take},{k * step:.2f},{seen:.3f},{duty},{SUPPLY}")
            brake = (1.0 - coasting * (1.0 - duty)) * K * K / R
            top = (K * duty * SUPPLY / R - FRICTION) / brake
            speed = top + (speed - top) * exp(-brake / J * step)
    return written(folder, rows, MAP)


@pytest.mark.parametrize("told", [1.0, -1.0])
def test_its_speed_comes_to_where_pulses_and_back_emf_balance(told):
    motor = VoltageDrive(K, R, coasting=0.75, supply=SUPPLY)
    servo = PositionServo(((0.0, 1e6 * told), (1.0, 1e6 * told)), 1.0, limit=3.0)
    run = simulate(
        Scenario("pulses", Testbed(J), (Clutch(Coulomb(1.0, 1.0)),), (0.0,), (0.0,), 0.2, (motor,),
                 ((servo, 1),), period=0.1)
    )  # fmt: skip
    closed = 1.0 - 0.75 * (1.0 - 3.0 / SUPPLY)
    expected = 3.0 / (closed * K) * (1.0 - exp(-closed * K * K / R / J * 0.2))
    assert run.end[1] == pytest.approx(told * expected, rel=1e-8)  # tolerance 1e-10 a step


@pytest.mark.slow
def test_it_is_named_with_its_part_and_the_corrected_model_lacks_nothing(tmp_path):
    recording = stairs(tmp_path, 0.8)
    done = diagnose(recording, parse(MODEL)).search
    assert [e.name for e in done.corrected.effects] == ["drive-coasting"]
    # The noise of 0.2 rad/s on some 600 rows leaves a per cent of it.
    assert done.corrected.values["drive-coasting.share"] == pytest.approx(0.8, abs=0.03)
    corrected = done.corrected.predictor.scenario(done.corrected.values)
    assert corrected.loads[0].supply == SUPPLY
    assert diagnose(recording, corrected).search.verdict.kind == "nothing missing"


def test_one_that_shorts_them_lacks_nothing(tmp_path):
    done = diagnose(stairs(tmp_path, 0.0), parse(MODEL)).search
    assert done.verdict.kind == "nothing missing"
