"""A number that is none, an exception, too many events: where, in which part, and what was kept."""

import math
from dataclasses import dataclass

import pytest

from simpter_hybrid.applied_load import Load
from simpter_hybrid.checks.validation import validate
from simpter_hybrid.clutch import Clutch, TorqueLaw
from simpter_hybrid.controller import Controller
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.running.recorder import Recorder, SimulationFailure


@dataclass(frozen=True)
class NanAfter(Load):
    start: float

    @staticmethod
    def tip_force(time, start, out):
        out[0] = 0.0
        out[1] = math.inf - math.inf if time >= start else 0.0


@dataclass(frozen=True)
class DividesByZero(Load):
    start: float

    @staticmethod
    def tip_force(time, start, out):
        out[0] = 0.0
        out[1] = 0.0 if time < start else 1.0 / 0.0


@dataclass(frozen=True)
class NanCommand(Controller):
    start: float

    @staticmethod
    def step(time, held, start):
        held[1] = math.nan if time >= start else 0.0


@dataclass(frozen=True)
class NanTorque(TorqueLaw):
    @staticmethod
    def slip_torque(excitation, time):
        return excitation if time < 0.1 else math.nan

    @staticmethod
    def break_torque(excitation):
        return 2.0 * excitation


LINE = load("line-y24", ["run.rtol=1e-6"])
LATE = {
    "load": (LINE.replace(loads=(*LINE.loads, NanAfter(0.3))), "load 2, tip_force"),
    "exception": (
        LINE.replace(loads=(*LINE.loads, DividesByZero(0.3))),
        "load 2, tip_force failed",
    ),
    "controller": (
        LINE.replace(controllers=(*LINE.controllers, (NanCommand(0.3), 1))),
        "the command of clutch 2 is nan; it came from controller 3, step",
    ),
    "torque": (
        LINE.replace(clutches=(*LINE.clutches[:2], Clutch(NanTorque()), LINE.clutches[3])),
        "clutch 3, torque_slip_torque",
    ),
    "events": (LINE.replace(event_limit=2), "more than 2 events (event_limit"),
}


@pytest.mark.parametrize("kind", LATE)
def test_a_run_fails_with_the_place_and_keeps_what_there_was(kind):
    scenario, said = LATE[kind]
    trajectory = simulate(scenario)
    assert trajectory.status == "failed"
    assert said in trajectory.message
    assert "t = " in trajectory.message
    assert 0.0 < trajectory.t_end < 1.0
    assert all(math.isfinite(v) for v in trajectory.state(trajectory.t_end))


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        (LINE.replace(loads=(NanAfter(0.0),)), "loads.0: load 1, tip_force hands back a number"),
        (LINE.replace(loads=(DividesByZero(0.0),)), "load 1, tip_force fails at the start (Zero"),
        (LINE.replace(controllers=((NanCommand(0.0), 1),)), "controller 1, step hands back"),
        (LINE.replace(t_end=math.inf), "run.t_end: out of range"),
        (LINE.replace(period=math.nan), "controller.period: not a period"),
        (LINE.replace(q=(math.nan, 0.0)), "start.coordinates: not finite"),
        (LINE.replace(q=(0.0,)), "start.coordinates: wrong number"),
        (LINE.replace(clutches=LINE.clutches[:3]), "clutches: wrong number of clutches"),
        (LINE.replace(period=0.0), "controller.period: no period, but controllers"),
        (
            LINE.replace(clutches=(Clutch(LINE.clutches[0].torque, time_constant=-1.0),) * 4),
            "clutches.0.time_constant: out of range",
        ),
    ],
)
def test_what_can_be_known_before_is_said_before(changed, said):
    with pytest.raises(InvalidInput) as caught:
        validate(changed)
    assert said in str(caught.value)


def test_an_interrupt_keeps_what_there_was():
    def at_half_a_second(t):
        if t > 0.5:
            raise KeyboardInterrupt

    trajectory = simulate(LINE, at_half_a_second)
    assert trajectory.status == "interrupted"
    assert 0.5 < trajectory.t_end < 0.6


def test_events_without_end_are_reported_with_the_last_of_them():
    recorder = Recorder(LINE)
    _, w = LINE.initial(lambda k: [0.0] * k, lambda k: [0] * k)
    recorder.event(0.7, "breakaway", (0, 2, 2, 2), w)

    def count_for_ever():
        while True:
            recorder.count_event(0.7)

    with pytest.raises(SimulationFailure, match=r"within 1e-9 s \(Zeno\): .*; last: .*\(1,\)"):
        count_for_ever()
