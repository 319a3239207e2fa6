"""Where a slider breaks away and stops again in closed form; a recorded end does the same."""

from dataclasses import replace
from math import atan, cos, pi, sin, sqrt

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.held_inputs import HOLDS
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.loads.pulled_spring import PulledSpring
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample

MASS, STIFFNESS, LEVEL, BREAKS, PACE = 2.0, 800.0, 3.0, 3.75, 0.05
SLIDER = """[run]
t_end = "0.5 s"
[device]
kind = "linear-axis"
mass = "2 kg"
[start]
coordinates = ["0 m"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "3 N", stiction = 0.25 }
[[loads]]
kind = "pulled-spring"
points = [["0 s", "0 m"], ["0.5 s", "0.025 m"]]
stiffness = "800 N/m"
"""


def test_it_breaks_away_and_stops_where_the_closed_form_says():
    run, w = simulate(parse(SLIDER)), sqrt(STIFFNESS / MASS)
    breaks, slack = BREAKS / (STIFFNESS * PACE), (BREAKS - LEVEL) / STIFFNESS
    # From there on x = v s + slack (1 - cos w s) - v / w sin w s.
    stops = breaks + (2 * pi - 2 * atan(slack * w / PACE)) / w
    assert [e.t for e in run.events[1:3]] == pytest.approx([breaks, stops], rel=1e-9)
    s = 0.2
    position = PACE * s + slack * (1.0 - cos(w * s)) - PACE / w * sin(w * s)
    assert sample(run, [breaks + s]).q[0, 0] == pytest.approx(position, rel=1e-8)
    assert energy_balance(run).relative < 1e-8


def test_a_damper_in_it_pulls_by_the_ends_speed():
    dashed = replace(parse(SLIDER), loads=(PulledSpring(((0.0, 0.0), (1.0, PACE)), 1e-6, 100.0),))
    # The damper alone: m x'' = c (v - x') - F from x' = 0 on, with c v = 5 N above 3.75 N.
    end = simulate(replace(dashed, t_end=0.1)).end
    fastest, lag = PACE - LEVEL / 100.0, MASS / 100.0
    assert end[1] == pytest.approx(fastest * (1.0 - np.exp(-0.1 / lag)), rel=1e-6)


def test_a_recorded_end_pulls_as_the_curve_it_was_read_from():
    corners = ((0.0, 0.0), (0.3, 0.015), (0.5, 0.01))
    model, rate = replace(parse(SLIDER), loads=(PulledSpring(corners, STIFFNESS),)), 100.0
    time = np.arange(0.0, 0.5, 1.0 / rate)
    end = np.interp(time, *np.array(corners).T)
    ones = np.ones(time.size)
    inputs = {"drive": end, "released": 0 * ones, "press": 0 * ones, "holds": 0 * ones}
    replay = Replay("run", "run", time, inputs, {}, notes={"start": np.zeros(2)})
    for held, points in (
        ("sampled", list(zip(time, end, strict=True))),
        ("after", [p for t, x in zip(time, end, strict=True)
                   for p in ((t, x), (t + 1.0 / rate - 1e-9, x))]),
    ):  # fmt: skip
        holds = {**inputs, "holds": HOLDS[held] * ones}
        rig = AxisRig(servo=True, played=1.0 / rate)
        found = ScenarioPredictor(model, rig).predict({}, [replace(replay, inputs=holds)])
        pulled = replace(model, loads=(PulledSpring(tuple(points), STIFFNESS),), t_end=time[-1])
        exact = sample(simulate(pulled), time).q[:, 0]
        # Replays are integrated to 1e-7.
        assert found["position"][0] == pytest.approx(exact, abs=1e-7)
