"""``[only]`` of a map: runs in which a column reads otherwise are not read."""

from simpter_hybrid.identification.recordings.recording import load_recording

MAP = """
[time]
column = "t"
unit = "s"
[runs]
boundaries = ["run"]
[only]
seal = "O-ring"
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "input"
"""


def test_runs_of_another_seal_are_left_out(tmp_path):
    rows = ["run,seal,t,x"]
    for run, seal in enumerate(("O-ring", "lip", "O-ring")):
        rows += [f"{run},{seal},{0.01 * k:.2f},{run + 0.001 * k:.3f}" for k in range(60)]
    (tmp_path / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    found = load_recording(tmp_path / "data.csv", tmp_path / "map.toml")
    assert [run.channels["position"][0] for run in found.runs] == [0.0, 2.0]
