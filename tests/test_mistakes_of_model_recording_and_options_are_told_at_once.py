"""A user mends the model, the recording and the options of a diagnosis in one go."""

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


def test_a_spreadsheet_is_called_one(tmp_path, capsys):
    (tmp_path / "d.xlsx").write_bytes(b"PK")
    assert cli.main(["diagnose", str(tmp_path / "d.xlsx"), "--model", "testbed"]) == 2
    assert "a spreadsheet, got .xlsx; expected the sheet saved as .csv" in capsys.readouterr().err
