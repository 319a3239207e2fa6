"""A row that was lost makes the ones behind it no earlier: starts of windows go by stamps."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.joints_rig import joint_replays
from simpter_hybrid.identification.recordings.recording import load_recording

STEP, NOISE = 0.01, 1e-4
MAP = '[time]\ncolumn = "t"\nunit = "s"\n' + "".join(
    f'[channels.{signal}_{j}]\ncolumn = "{signal}{j}"\nunit = "{unit}"\nsign = 1\nrole = "{role}"\n'
    for j in (1, 2)
    for signal, unit, role in (
        ("position", "rad", "measured"), ("speed", "rad/s", "measured"), ("torque", "N*m", "input")
    )
)  # fmt: skip


def moved(time):
    """Positions and speeds of both joints."""
    return np.sin(3 * time) + 2 * time, 3 * np.cos(3 * time) + 2


@pytest.mark.parametrize("lost", [0, 10])
def test_they_start_as_near_as_the_noise_lets_them(tmp_path, lost):
    rows = np.arange(1500)
    time = STEP * (rows[rows % lost != 5] if lost else rows)
    rng, (q, w) = np.random.default_rng(0), moved(time)
    columns = {"t": time}
    for j in (1, 2):
        columns[f"position{j}"] = q + NOISE * rng.normal(size=time.size)
        columns[f"speed{j}"] = w + 10 * NOISE * rng.normal(size=time.size)
        columns[f"torque{j}"] = np.sin(time)
    table, head = np.column_stack([*columns.values()]), ",".join(columns)
    np.savetxt(tmp_path / "joints.csv", table, "%.7f", ",", header=head, comments="")
    (tmp_path / "map.toml").write_text(MAP)
    recording = load_recording(tmp_path / "joints.csv", tmp_path / "map.toml")
    (replay,) = joint_replays(recording)
    begun = recording.runs[0].time[replay.notes["start_at"]]
    off = replay.notes["states"][:, 0] - moved(begun)[0]
    # Parabolas through a dozen rows halve the noise; a step that is taken for two was 60 times it.
    assert np.sqrt(np.mean(off**2)) < NOISE
