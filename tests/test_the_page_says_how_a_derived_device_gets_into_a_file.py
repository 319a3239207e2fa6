"""docs/your-own-device.md: its example writes a device that a scenario file can name."""

import re
from pathlib import Path

from simpter_hybrid.derive import derive_device
from simpter_hybrid.files.scenario_file import parse

PAGE = (Path(__file__).parent.parent / "docs/your-own-device.md").read_text()
EXAMPLE = re.search(r"```python\n(from pathlib.*?)^```", PAGE, re.M | re.S)
SCENARIO = """
[run]
t_end = "1 s"
[device]
kind = "pendulum:Pendulum"
weight = "3 N*m"
[start]
coordinates = ["10 deg"]
[clutch]
torque = { kind = "linear", rated = "1 N*m" }
"""


def test_its_class_is_named_in_a_file(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    exec(EXAMPLE[1], {})
    device = parse(SCENARIO, folder=tmp_path).device
    assert device.parameters() == {"inertia": 0.05, "weight": 3.0}


def test_the_function_for_python_points_to_the_one_for_files():
    assert "derive_text" in derive_device.__doc__
    assert 'kind = "pendulum:Pendulum"' in derive_device.__doc__
