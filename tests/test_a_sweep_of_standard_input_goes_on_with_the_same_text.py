"""``simpter sweep -``: standard input is a file like any other, given again to go on."""

import io

from simpter_hybrid.cli import main


def test_a_sweep_of_standard_input_goes_on_with_the_same_text(monkeypatch, tmp_path, capsys):
    assert main(["show", "testbed-breakaway-7v"]) == 0
    text = capsys.readouterr().out.encode()
    words = ["--vary", "run.t_end=0.1 s,0.2 s", "--engine", "reference", "--no-pictures"]
    tables = []
    for _ in range(2):
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(text), encoding="utf-8"))
        assert main(["sweep", "-", *words, "--jobs", "1", "--out", str(tmp_path / "swept")]) == 0
        tables.append((tmp_path / "swept" / "table.csv").read_bytes())
    assert tables[0] == tables[1]
    assert len(list((tmp_path / "swept" / "cases").iterdir())) == 2
