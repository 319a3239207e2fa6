from pathlib import Path

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MAP = """
[time]
column = "t"
unit = "s"
[channels.position]
column = "q"
unit = "rad"
role = "measured"
sign = 1
"""


def test_the_last_of_several_files_may_be_empty(tmp_path: Path) -> None:
    t = 0.01 * np.arange(400)
    np.savez(tmp_path / "first.npz", t=t, q=np.sin(t))
    np.savez(tmp_path / "last.npz", t=np.zeros(0), q=np.zeros(0), about=np.ones(3))
    (tmp_path / "map.toml").write_text(MAP, encoding="utf-8")
    with pytest.raises(InvalidInput, match=r"last\.npz: the file is empty, got t, q of no value"):
        load_recording([tmp_path / "first.npz", tmp_path / "last.npz"], tmp_path / "map.toml")
