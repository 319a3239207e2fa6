"""Cogging that passes many times within a window: recorded accelerations show it, run after run."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.axis.traces import AxisTracer
from simpter_hybrid.identification.fitting.fitted_model import Split
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.repeating import LEAST, WHERE, repeating
from simpter_hybrid.identification.reporting.repeating_sentence import repeating_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict

STEP, NUMBER = 0.002, 42.0


def run(seed, cogging):
    """A motor with inertia 1 under a smooth random torque; its speed as a sensor shows it."""
    generator = np.random.default_rng(seed)
    fine = STEP / 10
    time = fine * np.arange(40_000)
    rates, phases = generator.uniform(0.3, 1.0, 4), generator.uniform(0.0, 6.0, 4)
    drive = 8.0 * np.sin(2 * np.pi * rates[:, None] * time + phases[:, None]).sum(axis=0)
    x, v, places, speeds = 0.0, 0.0, np.empty(time.size), np.empty(time.size)
    for k in range(time.size):
        places[k], speeds[k] = x, v
        v += fine * (drive[k] - np.tanh(20.0 * v) - cogging * np.sin(NUMBER * x))
        x += fine * v
    seen = speeds[::10] + generator.normal(0.0, 0.02, time.size // 10)
    notes = {"position": places[::10], "speed": seen}
    name = f"run {seed}"
    return Replay(name, name, time[::10], {"drive": drive[::10]}, {}, notes=notes)


def split(cogging):
    return Split([run(1, cogging), run(2, cogging)], [run(3, cogging)], [])


def diagnosis(coordinates, parts):
    search = SimpleNamespace(verdict=Verdict("unknown", None, (), coordinates))
    return SimpleNamespace(
        search=search, tracer=AxisTracer(1.0), split=parts, recording=None, empirical=None
    )


@pytest.fixture(scope="module")
def cogged():
    return split(6.0)


def test_its_number_is_found_and_other_runs_show_it_again(cogged):
    found = repeating(AxisTracer(1.0), cogged)
    # Places of 4 s in which it goes some turns tell a wave to a hundredth of one in the whole way.
    assert found.number == pytest.approx(NUMBER, abs=0.05)
    assert found.part > LEAST


def test_it_is_said_where_nothing_else_explains_that_it_depends_on_the_place(cogged):
    assert "repeats 42 times a turn" in repeating_sentence(diagnosis((WHERE,), cogged))
    assert repeating_sentence(diagnosis(("force:time",), cogged)) == ""


def test_where_nothing_repeats_nothing_is_told():
    assert repeating(AxisTracer(1.0), split(0.0)) is None


def test_nor_of_a_place_that_nobody_knows_or_of_another_rig(cogged):
    assert repeating(AxisTracer(1.0, turn=0.0), cogged) is None
    assert repeating(AxisTracer(1.0, drawn=True), cogged) is None
    assert repeating(lambda *_: {}, cogged) is None
