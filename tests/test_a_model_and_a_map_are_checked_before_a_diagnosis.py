"""`simpter check` reads what a diagnosis will: tolerances by the model's parameters, and maps."""

import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid import cli


@pytest.fixture
def checked(tmp_path, capsys):
    def check(**texts):
        for name, text in texts.items():
            (tmp_path / f"{name}.toml").write_text(text)
        status = cli.main(["check", *(str(tmp_path / f"{name}.toml") for name in texts)])
        return status, capsys.readouterr()

    return check


def test_both_are_sound(checked):
    status, said = checked(slide=MODEL, slide_map=MAP)
    assert status == 0
    assert "slide_map.toml: sound (map of position (measured, deg)" in said.out


def test_a_parameter_that_no_model_has_and_a_channel_without_a_sign_are_told_at_once(checked):
    model = MODEL.replace("clutch.1.torque.coulomb", "clutch.torque.coulomb")
    status, said = checked(slide=model, slide_map=MAP.replace("sign = 1\n", "", 1))
    assert status == 2
    assert "no such parameter" in said.err
    assert "did you mean clutch.1.torque.coulomb?" in said.err
    assert "sign" in said.err
