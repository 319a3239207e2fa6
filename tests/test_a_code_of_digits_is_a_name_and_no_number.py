"""007 is another run than 7, and a long number is not rounded to its neighbour."""

import numpy as np
import pytest
from axis_recordings import MAP

from simpter_hybrid.identification.recordings.recording import load_recording

TIME = 0.004 * np.arange(100)


def names(folder, takes, more=""):
    rows = [
        f"{take},{1e3 * t:.1f},{10 * np.sin(3 * t):.6f},{np.cos(t):.6f}"
        for take in takes for t in TIME
    ]  # fmt: skip
    (folder / "data.csv").write_text("\n".join(["take,ms,angle,torque", *rows]), encoding="utf-8")
    (folder / "map.toml").write_text(MAP.split("[split]")[0] + MAP[MAP.index("[channels.pos") :]
                                     + more, encoding="utf-8")  # fmt: skip
    return [run.name for run in load_recording(folder / "data.csv", folder / "map.toml").runs]


@pytest.mark.parametrize(
    ("takes", "named"),
    [
        (("007", "008"), ["take 007", "take 008"]),
        (("1234567890123456788", "1234567890123456789"),
         ["take 1234567890123456788", "take 1234567890123456789"]),
        (("1", "2.0"), ["take 1", "take 2"]),
        (("1", "2.0", "03"), ["take 1", "take 2", "take 03"]),
        (("1.0", "2.0", "1.0"), ["take 1", "take 2", "take 1 (2)"]),
    ],
)  # fmt: skip
def test_runs_have_the_names_that_the_file_has(tmp_path, takes, named):
    assert names(tmp_path, takes) == named


def test_one_of_them_is_asked_for_as_it_is_written(tmp_path):
    assert names(tmp_path, ("007", "008"), '[only]\ntake = "007"\n') == ["take 007"]
