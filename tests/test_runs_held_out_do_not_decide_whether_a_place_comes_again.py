"""An angle is folded by a turn if the fitted runs go beyond one, whatever others do."""

import numpy as np
import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording

TIME = 0.002 * np.arange(400)
ROBOT = {
    **dict.fromkeys(["position_1", "position_2"], ("rad", "measured")),
    **dict.fromkeys([f"command_{k}" for k in range(1, 5)], ("V", "input")),
    **dict.fromkeys(["force_x", "force_y"], ("N", "input")),
}
ROTOR = {
    "clutch_torque": ("N*m", "measured"), "motor_torque": ("N*m", "measured"),
    "position": ("rad", "measured"), "speed": ("rad/s", "measured"),
    "command": ("V", "input"), "reference_speed": ("rad/s", "input"),
}  # fmt: skip


def tracer(folder, model, channels, widths):
    """The tracer of runs that swing so wide [rad]: of one that fits, one that selects, one else."""
    rows = [",".join(["run", "t", *channels])]
    for run, width in enumerate(widths):
        moved = {
            "position": width * np.sin(8.0 * TIME),
            "speed": 8.0 * width * np.cos(8.0 * TIME),
            "reference": 8.0 * width * np.cos(8.0 * TIME),
        }
        columns = [moved.get(name.partition("_")[0], 0.0 * TIME) for name in channels]
        rows += [
            f"{run},{t:.3f}," + ",".join(f"{x:.6f}" for x in cells)
            for t, *cells in zip(TIME, *columns, strict=True)
        ]
    text = '[time]\ncolumn = "t"\nunit = "s"\n[runs]\nboundaries = ["run"]\ngroup = ["run"]\n'
    text += '[split]\nfit = ["run 0"]\nselect = ["run 1"]\nreport = ["run 2"]\n'
    for name, (unit, role) in channels.items():
        text += (
            f'[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\nrole = "{role}"\n'
        )
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    recording = as_recorded(load_recording(folder / "data.csv", folder / "map.toml"))
    made = bench_of(recording, load(find_model(model)), groups_of(recording))
    return made.tracer(made.parts["fit"])


@pytest.mark.parametrize(("model", "channels"), [("robot", ROBOT), ("testbed", ROTOR)])
@pytest.mark.parametrize(
    ("widths", "turn"), [((1.0, 1.0, 9.0), np.inf), ((9.0, 1.0, 1.0), 2 * np.pi)]
)
def test_the_fitted_runs_alone_tell(tmp_path, model, channels, widths, turn):
    found = np.ravel(tracer(tmp_path, model, channels, widths).turn)
    assert found == pytest.approx(turn)
