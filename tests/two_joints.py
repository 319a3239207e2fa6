"""Two driven joints of an arm, and runs of it by the reference engine as recordings."""

from dataclasses import replace

import numpy as np

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.measuring.sampling import sample

CHANNEL = '[channels.{name}]\ncolumn = "{name}"\nunit = "{unit}"\nsign = 1\nrole = "{role}"\n'
KINDS = {
    "position": ("rad", "measured"), "speed": ("rad/s", "measured"),
    "torque": ("N*m", "input"), "command": ("V", "input"),
}  # fmt: skip


def declared_joints(pressed=0.0, lag=0.0):
    """The double pendulum's model; the first clutch's friction for each volt [N m/V], its lag."""
    declared = load(find_model("dfki_double_pendulum"))
    values = {"clutch.1.torque.normal": pressed, "clutch.1.time_constant": lag}
    return with_parameters(declared, values)


def recorded_joints(folder, true, command=None, commands=None, t_end=1.6, pieces=1):
    """A run of `true` without noise; `command`: of clutch 1; `commands`: columns that are added."""
    times = np.arange(0.0, t_end, 0.005)
    drives = [1.2 * np.sin(4.0 * times), 0.6 * np.sin(7.0 * times + 1.0)]
    loads = tuple(
        RecordedForce(tuple(zip(times.tolist(), d.tolist(), strict=True)), coordinate=j)
        for j, d in enumerate(drives)
    )
    told = (command or 0.0, *true.command[1:]) if true.command else (command or 0.0, 0.0)
    end = replace(
        true, loads=loads, controllers=(), t_end=t_end - 0.01, command=told, excitation=told
    )
    seen = sample(simulate(end), times[times < t_end - 0.01])
    columns = {}
    for j in range(2):
        columns |= {f"position_{j + 1}": seen.q[:, j], f"speed_{j + 1}": seen.qd[:, j]}
        columns[f"torque_{j + 1}"] = drives[j][: seen.q.shape[0]]
    if command is not None:
        columns["command_1"] = np.full(seen.q.shape[0], command)
    for name, told in (commands or {}).items():
        columns[name] = np.array(told[: seen.q.shape[0]])
    return written(folder, seen.t, columns, pieces)


def written(folder, times, columns, pieces):
    """CSV and map of one run, cut into so many pieces, read."""
    names = list(columns)
    rows = [",".join(["t", *names])]
    values = np.column_stack([columns[n] for n in names])
    rows += [
        f"{t:.4f}," + ",".join(f"{v:.9g}" for v in row)
        for t, row in zip(times, values, strict=True)
    ]
    text = f'[time]\ncolumn = "t"\nunit = "s"\n[runs]\npieces = {pieces}\n'
    for name in names:
        unit, role = KINDS[name.rpartition("_")[0]]
        text += CHANNEL.format(name=name, unit=unit, role=role)
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(text, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")
