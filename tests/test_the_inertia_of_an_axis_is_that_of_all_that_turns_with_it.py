import pytest
from axis_recordings import MODEL, declared_axis

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.rigs.pose import inertia_of


def test_a_motor_behind_a_gear_counts_by_the_square_of_its_ratio():
    geared = MODEL.replace("[start]", 'rotor = "1e-6 kg*m^2"\ngear = 100.0\n[start]', 1)
    # Its own 0.02 and the motor's 1e-6 times 100^2.
    assert inertia_of(parse(geared)) == pytest.approx(0.03, rel=1e-12)
    assert inertia_of(declared_axis()) == 0.02
