"""A model for a diagnosis is checked by itself: lines of tolerances, friction that is never on."""

import pytest

from simpter_hybrid.cli import main

MODEL = """[run]
t_end = "300 s"
[start]
coordinates = ["0 m"]
[device]
kind = "linear-axis"
mass = "78 kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "3.0 N" }
[[tolerances]]
name = "rolling resistance"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.5
"""
NEVER_ON = "nothing commands friction beyond clutch.1.threshold"


def checked(folder, capsys, text):
    (folder / "car.toml").write_text(text, encoding="utf-8")
    main(["check", str(folder / "car.toml")])
    return "".join(capsys.readouterr())


@pytest.mark.parametrize(
    ("named", "said"),
    [
        ('"clutch.torque.coulomb"', "no such parameter"),
        ('"device.mass", "device.mass"', "stands more than once"),
    ],
)
def test_a_wrong_tolerance_is_told_with_its_line(tmp_path, capsys, named, said):
    told = checked(tmp_path, capsys, MODEL.replace('"clutch.1.torque.coulomb"', named))
    assert "car.toml:15: tolerances: " in told
    assert said in told


@pytest.mark.parametrize(
    ("gone", "told"), [('threshold = "-1 V"\n', True), ("", False), ("[[tolerances]]", False)]
)
def test_friction_that_nothing_switches_on_is_remarked_of_a_model_to_be_diagnosed(
    tmp_path, capsys, gone, told
):
    text = MODEL.replace(gone, "")
    if gone == "[[tolerances]]":
        text = MODEL[: MODEL.index(gone)].replace('threshold = "-1 V"\n', "")
    said = checked(tmp_path, capsys, text)
    assert "sound" in said
    assert (NEVER_ON in said) is told
