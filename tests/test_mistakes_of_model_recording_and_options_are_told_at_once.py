"""A user mends the model, the recording and the options of a diagnosis in one go."""

import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid import cli

ROWS = ["take,ms,angle,torque", "0,0,1,2", "0,2,one,3"]


def test_each_of_them_is_told(tmp_path, capsys):
    texts = {"m.toml": MODEL.replace("0.02 kg*m^2", "0.02 s"), "map.toml": MAP,
             "d.csv": "\n".join(ROWS)}  # fmt: skip
    for name, text in texts.items():
        (tmp_path / name).write_text(text)
    data, model, described = (str(tmp_path / name) for name in ("d.csv", "m.toml", "map.toml"))
    asked = ["diagnose", data, "--model", model, "--map", described, "--trials", "-1"]
    asked += ["--effort", "0", "--also", "nothing:No", "--out", model]
    assert cli.main(asked) == 2
    said = capsys.readouterr().err
    of = ("device.inertia", '"one"', "--trials", "--effort", "nothing:No", "--out")
    assert [name for name in of if name not in said] == []


@pytest.mark.parametrize(
    ("name", "said"),
    [("d.xlsx", "a spreadsheet, got .xlsx; expected the sheet saved as .csv"),
     ("d.json", "a format that is not read, got .json; expected its rows saved as .csv")],
)  # fmt: skip
def test_a_file_that_has_to_be_saved_as_text_is_called_what_it_is(tmp_path, capsys, name, said):
    (tmp_path / name).write_bytes(b"{}")
    assert cli.main(["diagnose", str(tmp_path / name), "--model", "testbed"]) == 2
    assert said in capsys.readouterr().err
