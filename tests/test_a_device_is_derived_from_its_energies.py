"""Symbols in, a device out: it is sound, equals what was written by hand, and runs from a file."""

import pickle

import numpy as np
import pytest
import sympy as sp
from devices_for_tests import Waves, always_on

from simpter_hybrid.derive import derive_device, derive_text
from simpter_hybrid.device_check import check_device
from simpter_hybrid.devices.two_link import TwoLink
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

Q, W = sp.symbols("q1 q2"), sp.symbols("w1 w2")
NAMES = "mass_1 mass_2 length_1 centre_1 centre_2 inertia_1 inertia_2 rotor_1 rotor_2 gravity"
SYMBOLS = dict(zip(NAMES.split(), sp.symbols(NAMES), strict=True))
VALUES = (0.52, 0.63, 0.2, 0.2, 0.256, 0.032, 0.051, 0.002, 0.001, 9.81)
DIMENSIONS = ("mass",) * 2 + ("length",) * 3 + ("inertia",) * 4 + ("acceleration",)


def energies():
    s = SYMBOLS
    (q1, q2), (w1, w2) = Q, W
    x, y = (s["length_1"] * f(q1) + s["centre_2"] * f(q1 + q2) for f in (sp.sin, sp.cos))
    vx, vy = (sum(sp.diff(c, a) * b for a, b in zip(Q, W, strict=True)) for c in (x, y))
    about_centre = s["inertia_2"] - s["mass_2"] * s["centre_2"] ** 2
    kinetic = (
        (s["inertia_1"] + s["rotor_1"]) * w1**2 / 2 + s["rotor_2"] * w2**2 / 2
        + s["mass_2"] * (vx**2 + vy**2) / 2 + about_centre * (w1 + w2) ** 2 / 2
    )  # fmt: skip
    height = s["mass_1"] * s["centre_1"] * sp.cos(q1) + s["mass_2"] * y
    return kinetic, -s["gravity"] * height


def derived(slips):
    kinetic, potential = energies()
    pairs = zip(DIMENSIONS, VALUES, strict=True)
    parameters = dict(zip(SYMBOLS.values(), pairs, strict=True))
    return ("Double", Q, W, kinetic, slips, parameters), {"potential": potential}


def test_a_derived_arm_equals_the_one_written_by_hand():
    arguments, options = derived({"shoulder": Q[0], "elbow": Q[1]})
    made, hand = derive_device(*arguments, **options), TwoLink(*VALUES)
    assert check_device(made) == []
    q, qd, p = [0.7, -1.1], [1.3, 0.4], list(VALUES)
    for name, length in (("mass_matrix", 4), ("conservative_force", 2)):
        one, other = [0.0] * length, [0.0] * length
        made.functions()[name](q, p, one)
        hand.functions()[name](q, p, other)
        # Two orders of a handful of operations.
        assert one == pytest.approx(other, rel=1e-13)
    one, other = [0.0] * 2, [0.0] * 2
    made.functions()["velocity_terms"](q, qd, p, one)
    hand.functions()["velocity_terms"](q, qd, p, other)
    assert one == pytest.approx(other, rel=1e-13)


def test_a_derived_device_with_a_map_that_depends_on_the_pose_sticks_exactly():
    along_x = SYMBOLS["length_1"] * sp.sin(Q[0]) + 0.5 * sp.sin(Q[0] + Q[1])
    arguments, options = derived({"shoulder": Q[0], "hand along x": along_x})
    device = derive_device(*arguments, **options)
    assert not device.constant_clutch_map
    run = simulate(
        Scenario("derived", device, (always_on(0.2, 0.3), always_on(1.5, 2.0)), (0.5, 0.4),
                 (1.0, -0.5), 1.5, loads=(Waves(((0, 0.5, 5.0, 0.0), (1, 0.3, 9.0, 1.0))),),
                 command=(1.0, 1.0), excitation=(1.0, 1.0))
    )  # fmt: skip
    assert run.status == "finished", run.message
    seen = sample(run, np.linspace(0.0, 1.5, 150))
    assert (seen.mode == 0).any()
    assert energy_balance(run, seen).relative < 1e-8
    for k in range(len(seen.t)):
        row = [0.0] * 4
        device.functions()["clutch_map"](seen.q[k].tolist(), run.scenario.parameter_values(), row)
        for i in range(2):
            if seen.mode[k, i] == 0:
                parts = [row[2 * i + j] * seen.qd[k, j] for j in range(2)]
                # Exactly zero but for rounding of the map.
                assert abs(sum(parts)) <= 1e-14 * max(1.0, *map(abs, parts))


def test_the_text_of_a_derived_device_is_a_module_that_a_file_may_name(tmp_path):
    arguments, options = derived({"shoulder": Q[0], "elbow": Q[1]})
    (tmp_path / "double.py").write_text(derive_text(*arguments, **options))
    (tmp_path / "double.toml").write_text(
        '[run]\nt_end = "0.2 s"\n[device]\nkind = "double:Double"\nmass_1 = "0.6 kg"\n'
        '[start]\ncoordinates = ["0.4 rad", "0 rad"]\n[clutch.torque]\nkind = "linear"\n'
        'rated = "1 N*m"\n'
    )
    run = simulate(load(tmp_path / "double.toml"))
    assert run.status == "finished"
    assert run.scenario.device.mass_1 == 0.6


def test_what_cannot_be_derived_is_explained():
    arguments, options = derived({"shoulder": Q[0] * sp.Symbol("k")})
    with pytest.raises(ValueError, match="unknown symbols k"):
        derive_text(*arguments, **options)
    arguments, options = derived({"shoulder": W[0] ** 2})
    with pytest.raises(ValueError, match="not linear in the speeds"):
        derive_text(*arguments, **options)
    name, q, w, kinetic, slips, parameters = derived({"shoulder": Q[0]})[0]
    with pytest.raises(ValueError, match="quadratic"):
        derive_text(name, q, w, kinetic * W[0], slips, parameters)


def test_two_derived_devices_of_one_name_can_be_pickled():
    (arguments, options), mass = derived({"shoulder": Q[0]}), SYMBOLS["mass_1"]
    one = derive_device(*arguments, **options)
    arguments[-1][mass] = ("mass", 2.0)
    other = derive_device(*arguments, **options)
    for made in (one, other):
        assert pickle.loads(pickle.dumps(made)) == made
    assert (one.mass_1, other.mass_1) == (0.52, 2.0)


@pytest.mark.parametrize(
    ("coordinates", "speeds", "word"),
    [("out b", "w1 w2", "out"), ("cos b", "w1 w2", "cos"), ("a pi", "w1 w2", "pi"),
     ("a p", "w1 w2", "p"), ("a b", "p w2", "p"), ("a b", "w1 out", "out")],
)  # fmt: skip
def test_a_symbol_may_not_hide_what_the_code_uses(coordinates, speeds, word):
    q, w, mass = sp.symbols(coordinates), sp.symbols(speeds), sp.Symbol("mass")
    kinetic = mass * (w[0] ** 2 + w[1] ** 2 + w[0] * w[1] * sp.cos(q[0] - q[1]))
    with pytest.raises(ValueError, match=f"'{word}' is a name that the code uses"):
        derive_text("Own", q, w, sp.pi * kinetic, {"a": q[0]}, {mass: ("mass", 1.0)})


def test_a_parameter_may_not_hide_what_its_class_uses():
    q, w, mass = sp.symbols("q w float")
    with pytest.raises(ValueError, match="'float' is a name that the code uses"):
        derive_text("Own", [q], [w], mass * w**2, {"a": q}, {mass: ("mass", 1.0)})


def test_a_lone_coordinate_may_be_called_q():
    q, w, mass = sp.symbols("q qd p")
    made = derive_device("Own", [q], [w], mass * w**2 / 2, {"a": q}, {mass: ("mass", 1.0)})
    assert check_device(made) == []
