"""A motion that grows without bound: told with its numbers, without warnings, and no balance."""

import math
import warnings

import pytest
from sampled_runs import SpringBlock, engaged

from simpter_hybrid import engine
from simpter_hybrid.cli import main
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.regularised import simulate as smoothed
from simpter_hybrid.scenario import Scenario

SLIDE = """
[run]
t_end = "8 s"
[start]
coordinates = ["0 m"]
speeds = ["1 m/s"]
[device]
kind = "linear-axis"
mass = "2 kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "3 N" }
[[effects]]
kind = "viscous-drag"
coordinate = "slide"
coefficient = "-300 N*s/m"
"""


@pytest.mark.parametrize("simulate", [engine.simulate, smoothed])
def test_what_grows_is_named_with_its_number(simulate):
    drag = ViscousDrag(coordinate=0, coefficient=-600.0)
    block = Scenario("block", SpringBlock(), (engaged(3.0),), (0.5,), (1.0,), 9.0, effects=(drag,))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = simulate(block)
    assert run.status == "failed"
    assert "s the motion has grown without bound: speed of x is " in run.message
    assert "np.float64" not in run.message
    balance = energy_balance(run)
    assert (balance.relative is None) == (not math.isfinite(balance.turnover))


@pytest.mark.parametrize("kind", ["reference", "compiled"])
def test_a_command_warns_of_nothing_and_tells_no_balance(kind, tmp_path, capsys):
    file = tmp_path / "slide.toml"
    file.write_text(SLIDE)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        code = main(["run", str(file), "--engine", kind, "--quiet", "--out", f"{tmp_path}/run"])
    printed = capsys.readouterr()
    assert (code, printed.err) == (3, "")
    assert printed.out.startswith("failed: at t = ")
    assert "balance" not in printed.out
