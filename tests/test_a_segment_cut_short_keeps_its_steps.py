"""Ctrl-C, or a number that is not finite, late in a long segment: what came before is kept."""

import numpy as np

import simpter_hybrid as simpter
from simpter_hybrid.cli import main
from simpter_hybrid.engine import simulate


def interrupt_after(t_last):
    def progress(t):
        if t > t_last:
            raise KeyboardInterrupt

    return progress


def test_an_interrupted_run_is_the_beginning_of_the_whole_run():
    scenario = simpter.load("reduced-clutch-1")
    whole = simulate(scenario)
    part = simulate(scenario, interrupt_after(2.0))
    assert part.status == "interrupted"
    assert part.segment_t[-1, 0] < 1.0 < 1.5 < part.t_end < whole.t_end
    count = len(part.step_t)
    assert np.array_equal(part.step_t, whole.step_t[:count])
    assert np.array_equal(part.step_f, whole.step_f[:count])
    assert np.array_equal(part.end, part.state(part.t_end, "left"))


FAST = """
name = "fast"
[run]
t_end = "1 s"
[device]
kind = "testbed"
inertia = "1 kg*m^2"
[start]
coordinates = ["0 rad"]
speeds = ["1e200 rad/s"]
[clutch.torque]
kind = "linear"
rated = "4 N*m"
"""


def test_energies_beyond_the_largest_number_fail_the_check(tmp_path, capsys):
    (tmp_path / "fast.toml").write_text(FAST)
    options = ["--no-report", "--quiet", "--out", str(tmp_path / "run")]
    assert main(["run", str(tmp_path / "fast.toml"), *options]) == 1
    assert "energies too large" in capsys.readouterr().err
