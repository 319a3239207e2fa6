from dataclasses import replace

import pytest
from axis_recordings import MODEL, declared_axis, recorded_axis

from simpter_hybrid.identification.benches import check_fits
from simpter_hybrid.identification.rigs.pose import inertia_of
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario_file import parse


def test_a_motor_behind_a_gear_counts_by_the_square_of_its_ratio():
    geared = MODEL.replace("[start]", 'rotor = "1e-6 kg*m^2"\ngear = 100.0\n[start]', 1)
    # Its own 0.02 and the motor's 1e-6 times 100^2.
    assert inertia_of(parse(geared)) == pytest.approx(0.03, rel=1e-12)
    assert inertia_of(declared_axis()) == 0.02


def test_one_without_any_is_refused(tmp_path):
    recording = recorded_axis(tmp_path, [])
    device = replace(declared_axis().device, inertia=0.0)
    with pytest.raises(InvalidInput, match="nothing that moves has an inertia"):
        check_fits(recording, replace(declared_axis(), device=device))
