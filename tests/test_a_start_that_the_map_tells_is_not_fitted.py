"""What is known of where a run that nothing drives begins is left alone; the rest is fitted."""

from dataclasses import replace

import numpy as np
import pytest
from free_swing import START, TURN, Swing, swung

from simpter_hybrid.identification.rigs.free_start import begun_near, started

VALUES = {"turn": TURN}


def told(position, speed, at):
    run = swung()
    return replace(run, start_told=(position, speed), notes={**run.notes, "start": np.array(at)})


def test_a_speed():
    (found,) = started(Swing().simulated, VALUES, [told(False, True, [0.03, START[1]])])
    assert found.notes["start"][1] == START[1]
    # As where both are fitted: four deviations of an amplitude by 1200 rows.
    assert found.notes["start"][0] == pytest.approx(START[0], abs=4 * 6e-5)


def test_a_position():
    (found,) = started(Swing().simulated, VALUES, [told(True, False, [START[0], -0.2])])
    assert found.notes["start"][0] == START[0]
    assert found.notes["start"][1] == pytest.approx(START[1], abs=4 * 6e-5 * TURN)


def test_or_both_though_they_are_wrong():
    run = told(True, True, [0.03, -0.2])
    (found,) = started(Swing().simulated, VALUES, [run])
    assert found.notes["start"].tolist() == [0.03, -0.2]
    near = begun_near(Swing().simulated, VALUES, [run])
    assert np.array_equal(near["position"][0], Swing().simulated(VALUES, [run])["position"][0])
