"""What a fit finds wrong with sensors is written as [readings]; a model with them predicts it."""

from dataclasses import replace

import numpy as np
import pytest
import robot_replays as robot
from axis_recordings import declared_axis

from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.replay import Breakaway, Observation, Replay
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.sensor_errors import told_errors, with_errors
from simpter_hybrid.identification.rotor.candidates import rotor_candidates
from simpter_hybrid.identification.rotor.rig import RotorRig
from simpter_hybrid.identification.tip.rig import TipRig, TipSignals
from simpter_hybrid.identification.tip.sensors import sensed, sensor_errors
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sensor import Sensor

#: Replays of the robot are integrated to 1e-7, of the rotor (10 N m) to 1e-5.
ANGLE, TORQUE = 1e-7, 1e-4


def rotor_replay():
    time = 2e-3 * np.arange(1, 200)
    inputs = {
        "command": np.full(time.size, 4.0), "reference_speed": 1.0 + np.sin(20.0 * time),
        "neighbour_command": np.zeros(time.size),
    }  # fmt: skip
    seen = Observation(np.zeros(time.size), 0.2, np.ones(time.size, bool))
    return Replay("run", "run", time, inputs, {"clutch_torque": seen})


def both_ways(declared, rig, found, replay, channels):
    """Predictions with what was found, from the file it was written to, and without it."""
    bare = ScenarioPredictor(declared, rig)
    fitted = bare
    for candidate in found:
        fitted = fitted.extended(candidate)
    values = {p.name: p.value for p in fitted.parameters}
    values |= {p.name: p.value + 5 * p.typical for c in found for p in c.parameters}
    text = resolve(fitted.scenario(values)).text
    written = ScenarioPredictor(parse(text), rig)
    nominal = {p.name: p.value for p in written.parameters}
    runs = [(fitted, values), (written, nominal), (bare, nominal)]
    series = [model.predict(v, [replay]) for model, v in runs]
    return text, [np.concatenate([s[c][0] for c in channels]) for s in series]


@pytest.mark.parametrize(
    "names", [("force-gain",), ("force-offset",), ("force-delay",), ("angle-offset",),
              ("angle-gain",), ("force-turned",), ("force-crosstalk",),
     ("force-gain", "force-offset", "force-turned", "force-crosstalk", "force-delay",
      "angle-gain")],
    ids=" ".join,
)  # fmt: skip
def test_a_robots_sensors_are_written_as_readings_that_predict_the_same(names):
    found = [robot.candidates()[name] for name in names]
    channels = ("position_1", "position_2")
    text, (fitted, written, bare) = both_ways(
        robot.declared(), TipRig(), found, robot.replay(), channels
    )
    assert "[readings]" in text
    assert "tip-spring" not in text
    assert np.abs(fitted - bare).max() > 1e-4
    assert written == pytest.approx(fitted, abs=ANGLE)


CLUTCH, MOTOR = ("clutch_torque", "friction on rotor"), ("motor_torque", "load on rotor")


@pytest.mark.parametrize(
    ("name", "channel", "signal"),
    [("sensor gain", *CLUTCH), ("sensor offset", *CLUTCH), ("sensor lag", *CLUTCH),
     ("sensor delay", *CLUTCH), ("motor sensor gain", *MOTOR), ("motor sensor offset", *MOTOR)],
)  # fmt: skip
def test_a_rotors_sensor_is_written_as_readings_that_predict_the_same(name, channel, signal):
    found = [c for c in rotor_candidates() if c.name == name]
    declared = load(find_model("testbed"))
    text, (fitted, written, bare) = both_ways(
        declared, RotorRig(), found, rotor_replay(), [channel]
    )
    assert f'signal = "{signal}"' in text
    assert np.abs(fitted - bare).max() > 0.05
    assert written == pytest.approx(fitted, abs=TORQUE)


@pytest.mark.parametrize("name", ["force-gain", "force-delay", "force-lag"])
def test_the_force_sensor_of_an_axis_is_written_as_readings_that_predict_the_same(name):
    found = [c for c in drive_candidates(declared_axis(), True) if c.name == name]
    time = 4e-3 * np.arange(1, 200)
    nothing, start = np.zeros(time.size), np.zeros(2)
    inputs = {"drive": 0.9 * np.sin(20.0 * time), "released": nothing, "press": nothing,
              "holds": nothing}  # fmt: skip
    seen = Observation(nothing, 0.2, np.ones(time.size, bool))
    run = Replay("run", "run", time, inputs, {"speed": seen}, notes={"start": start})
    text, (fitted, written, bare) = both_ways(
        declared_axis(), AxisRig(sensed=True), found, run, ["speed"]
    )
    assert 'signal = "load on joint"' in text
    assert np.abs(fitted - bare).max() > 0.01
    assert written == pytest.approx(fitted, abs=TORQUE)


def test_they_are_written_for_a_model_without_a_controller():
    moved = replace(declared_axis(), controllers=(), loads=(), period=0.0)
    made = with_errors(moved, {("load on joint", "delay"): 0.01})
    ((key, _),) = told_errors(parse(resolve(made).text), {("load on joint", "delay")}).items()
    assert key == ("load on joint", "delay")


def test_a_sensor_with_the_errors_written_shows_what_is_put_right_again():
    pter = robot.declared().device
    values = {"force-gain.x": 0.1, "force-gain.y": -0.05, "force-offset.x": 2.0}
    values |= {"force-offset.y": -1.0, "force-delay.x": 0.01, "force-delay.y": -0.004}
    errors = sensor_errors(values, pter)
    shown = {}
    for k, axis in enumerate("xy"):
        own = {field: errors[f"tip force {axis}", field] for field in ("gain", "offset")}
        late = errors[f"tip force {axis}", "delay"]
        sensor = Sensor(**own, delay=max(late, 0.0), clock_shift=max(-late, 0.0))
        shown[f"force_{axis}"] = sensor.read(robot.TIME, lambda t, k=k: robot.force(t)[k])
    run = robot.replay()
    right = sensed(replace(run, inputs=run.inputs | shown), values, TipSignals())
    inner = slice(10, -10)  # beyond its ends a record is held
    for k, axis in enumerate("xy"):
        # Straight lines over 2 ms miss a sine of 5 rad/s by (5 * 0.002)^2 / 8 of 30 N.
        expected = robot.force(robot.TIME)[k][inner]
        assert right.inputs[f"force_{axis}"][inner] == pytest.approx(expected, abs=4e-4)


def test_a_fit_finds_what_is_more_than_declared_and_noise_stays():
    declared = with_errors(robot.declared(), {("tip force x", "gain"): 0.1})
    found = ScenarioPredictor(declared, TipRig()).extended(robot.candidates()["force-gain"])
    values = {p.name: p.value for p in found.parameters} | {"force-gain.x": 0.02}
    made = found.scenario(values).notes["readings"]
    assert [c.sensor.gain for c in made.channels] == pytest.approx([0.12])
    noisy = replace(made, channels=(replace(made.channels[0], sensor=Sensor(noise=0.3)),))
    again = with_errors(
        replace(declared, notes={**declared.notes, "readings": noisy}),
        {("tip force x", "delay"): -0.003},
    )
    (channel,) = again.notes["readings"].channels
    assert (channel.sensor.noise, channel.sensor.clock_shift) == (0.3, 0.003)


def test_a_sensor_that_a_rig_cannot_take_into_account_is_refused():
    wrong = with_errors(robot.declared(), {("tip x", "gain"): 0.1, ("tip force x", "filter"): 0.01})
    with pytest.raises(InvalidInput) as found:
        _ = ScenarioPredictor(wrong, TipRig()).declared_sensor_errors
    assert len(found.value.problems) == 2
    assert "gain of 'tip force x'" in found.value.problems[0].right
    harmless = with_errors(robot.declared(), {("tip x", "noise"): 0.1})
    assert told_errors(harmless, ()) == {}


@pytest.mark.parametrize("delay", [0.01, -0.01])
def test_a_delay_moves_the_torque_and_lets_levels_stand(delay):
    time, slope, at = 2e-3 * np.arange(1, 200), -20.0, 150
    found = Breakaway(at + 1, slope * time[at], 0.1)
    run = Replay("run", "run", time, {"reference_torque": slope * time}, {}, (), (found,))
    holds = np.zeros(time.size)
    holds[at] = 5.8
    channels = {"clutch_torque": slope * time, "breakaway_torque": holds}
    RotorRig().read(run, {"sensor delay.delay": delay}, channels)
    assert channels["breakaway_torque"][at] == 5.8
    assert channels["clutch_torque"][at] == pytest.approx(slope * (time[at] - delay), abs=1e-9)


def test_a_level_of_breakaway_is_read_off_the_same_sensor():
    time, slope, at = 2e-3 * np.arange(1, 200), -20.0, 150
    found = Breakaway(at + 1, slope * time[at], 0.1)
    inputs = {"reference_torque": slope * time}
    run = Replay("run", "run", time, inputs, {}, (), (found,))
    holds = np.zeros(time.size)
    holds[at] = 5.8
    channels = {"clutch_torque": slope * time, "breakaway_torque": holds}
    values = {"sensor gain.gain": 0.1, "sensor offset.offset": 0.3, "sensor lag.lag": 0.01}
    RotorRig().read(run, values, channels)
    # After 30 time constants a lag of 10 ms shows what the ramp was 10 ms before.
    assert channels["breakaway_torque"][at] == pytest.approx(1.1 * (5.8 - 0.2) - 0.3, abs=1e-9)
    shown = 1.1 * slope * (time[at] - 0.01) + 0.3
    assert channels["clutch_torque"][at] == pytest.approx(shown, abs=1e-9)
