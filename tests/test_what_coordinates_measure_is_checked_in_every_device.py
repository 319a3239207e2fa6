"""``coordinate_dimensions``: empty, or an angle or a length for every coordinate; else told."""

import pytest
import sympy as sp

from simpter_hybrid import run
from simpter_hybrid.cli import main
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.derive import derive_text
from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.belt_and_mass import BeltAndMass
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

WRONG = {
    "('Length', 'Length')": "'Length' is nothing that a coordinate measures",
    "('lenght', 'length')": "'lenght' is nothing",
    "('length',)": "1 for 2 coordinates",
    "('length',) * 3": "3 for 2 coordinates",
    "'length'": "not a tuple",
}
MODULE = """
from simpter_hybrid.devices.belt_and_mass import BeltAndMass
class Pair(BeltAndMass):
    coordinate_dimensions = {}
def pair():
    return Pair(1.0, 4.0)
"""
FILE = """
[run]
t_end = "1 s"
[device]
kind = "{}"
{}
[start]
coordinates = ["0 m", "0 m"]
"""


def pair(kinds):
    return type("Pair", (BeltAndMass,), {"coordinate_dimensions": kinds})(1.0, 4.0)


@pytest.mark.parametrize("kinds", WRONG)
def test_a_check_finds_it(kinds):
    (found,) = check_device(pair(eval(kinds)))
    assert found.array == "coordinate_dimensions"
    assert WRONG[kinds] in found.what
    assert "a tuple of 2, each 'angle' or 'length'" in found.right


def test_none_and_a_mixture_are_sound():
    assert check_device(pair(())) == []
    assert check_device(pair(("angle", "length"))) == []


@pytest.mark.parametrize("kinds", WRONG)
@pytest.mark.parametrize("made", ["class", "function"])
def test_a_file_with_such_a_device_has_a_problem(kinds, made, tmp_path, capsys):
    (tmp_path / "pairs.py").write_text(MODULE.format(kinds))
    kind, numbers = ("pairs:pair", "")
    if made == "class":
        kind, numbers = "pairs:Pair", 'mass = "1 kg"\nstiffness = "4 N/m"'
    (tmp_path / "s.toml").write_text(FILE.format(kind, numbers))
    assert main(["check", str(tmp_path / "s.toml")]) == 2
    said = capsys.readouterr().err
    assert "device.kind: Pair.coordinate_dimensions" in said
    assert WRONG[kinds] in said


def test_a_scenario_made_in_python_is_checked_as_well():
    made = Scenario(
        name="pair", device=pair(("Length", "Length")), clutches=(Clutch(LinearTorque(1.0)),),
        q=(0.0, 0.0), qd=(0.0, 0.0), t_end=1.0,
    )  # fmt: skip
    with pytest.raises(InvalidInput, match="coordinate_dimensions: 'Length' is nothing"):
        run(made)


@pytest.mark.parametrize("dimensions", [("lenght",), ("length", "angle"), "length"])
def test_no_device_is_derived_with_them(dimensions):
    x, v, m = sp.symbols("x v m_0")
    with pytest.raises(ValueError, match=r"dimensions: .*a tuple of 1, each"):
        derive_text("One", [x], [v], m * v**2 / 2, {}, {m: ("mass", 1.0)}, dimensions=dimensions)
