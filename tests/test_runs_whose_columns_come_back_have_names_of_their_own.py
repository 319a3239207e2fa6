"""Results are kept by the names of runs: two of one name would be one."""

import pytest
from axis_recordings import MAP, written


@pytest.mark.parametrize(
    ("takes", "names"),
    [
        (["on", "off", "on"], ["on", "off", "on (2)"]),
        (["1", "2", "1", "1 (2)"], ["1", "2", "1 (3)", "1 (2)"]),
        (
            ["1", "1 (2)", "1", "2", "1", "1 (2)"],
            ["1", "1 (2)", "1 (3)", "2", "1 (4)", "1 (2) (2)"],
        ),
    ],
)
def test_none_that_another_run_has(tmp_path, takes, names):
    described = MAP[: MAP.index("[split]")] + MAP[MAP.index("[channels.position]") :]
    rows = [f"{take},{k},{k % 7},{k % 5}" for take in takes for k in range(60)]
    recorded = written(tmp_path, ["take,ms,angle,torque", *rows], described)
    assert [run.name for run in recorded.runs] == [f"take {name}" for name in names]
