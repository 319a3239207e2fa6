"""A motor that a step of voltage drove is asked for no motion that its voltage cannot make."""

import numpy as np
import pytest
from axis_recordings import MAP
from axis_recordings import MODEL as DRIVEN

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.plan import axis_reach, planned_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.recordings.recording import load_recording

#: N m/A, ohm, kg m^2, N m, V: 0.057 N m at stall, a time constant of 0.89 s.
CONSTANT, RESISTANCE, INERTIA, FRICTION, VOLTS = 0.013, 2.74, 5.5e-5, 0.0022, 12.0
#: The axis of other tests, with this motor.
MODEL = (
    DRIVEN.partition("[[tolerances]]")[0]
    .replace("0.02 kg*m^2", f"{INERTIA} kg*m^2").replace('weight = "0.5 N*m"\n', "")
    .replace('"0.2 N*m", viscous = "0.02 N*m*s/rad"', f'"{FRICTION} N*m"')
    .replace('"force-drive"', f'"voltage-drive"\nresistance = "{RESISTANCE} ohm"')
    .replace("1 N*m/V", f"{CONSTANT} N*m/A").replace("500 Hz", "2 kHz")
    .replace('limit = "1 V"\n', "")
)  # fmt: skip
STEP = 5e-3


def stepped(folder):
    """The recording of a step, in closed form, and the model; after 3 s it is near full speed."""
    t, late = STEP * np.arange(601), INERTIA * RESISTANCE / CONSTANT**2
    fastest = (CONSTANT * VOLTS / RESISTANCE - FRICTION) * RESISTANCE / CONSTANT**2
    angle = fastest * (t - late * (1.0 - np.exp(-t / late)))
    rows = [f"0,{1e3 * a},{np.degrees(-b)},{VOLTS}" for a, b in zip(t, angle, strict=True)]
    text = "\n".join(["take,ms,angle,volt", *rows])
    (folder / "data.csv").write_text(text, encoding="utf-8")
    drive = MAP.replace("channels.torque", "channels.drive").replace('"torque"', '"volt"')
    (folder / "map.toml").write_text(drive.replace("lbf*in", "V"), encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    return recording, parse(MODEL, source="model")


@pytest.fixture(name="planned", scope="module")
def _planned(tmp_path_factory):
    recording, model = stepped(tmp_path_factory.mktemp("step"))
    replays = axis_replays(recording, AxisSignals())
    reach = axis_reach(replays, INERTIA, CONSTANT / RESISTANCE)
    assert reach.force == pytest.approx(CONSTANT * VOLTS / RESISTANCE)
    return reach, planned_axis(recording, model, reach, AxisSignals())


def made_of(told, start, few=200):
    """Position by the motor's law (semi-implicit Euler); `told`: what gives each step's volts."""
    at, speed, found = start, 0.0, [start]
    for law in told:
        for k in range(few):
            u = law(k / few, at, speed)
            push = CONSTANT * (u - CONSTANT * speed) / RESISTANCE
            rubs = FRICTION * np.sign(speed) if speed else np.clip(push, -FRICTION, FRICTION)
            after = speed + STEP / few * (push - rubs) / INERTIA
            speed = 0.0 if after * speed < 0.0 else after
            at += STEP / few * speed
        found.append(at)
    return np.array(found)


def test_its_drive_makes_the_motion_that_is_laid_down_and_that_is_replayed(planned):
    _, (recording, asked) = planned
    assert len(asked) > 4
    runs = {run.name: run for run in recording.runs}
    assert runs.keys() == asked.keys()
    for name, laid in asked.items():
        way = np.ptp(laid["position"])
        assert list(laid) == ["position", "drive"]
        assert np.abs(laid["drive"]).max() == pytest.approx(0.9 * VOLTS)
        held = [lambda part, at, speed, u=u: u for u in laid["drive"][:-1].tolist()]
        other = made_of(held, float(laid["position"][0]))
        assert np.abs(other - laid["position"]).max() < 0.01 * way
        assert np.abs(runs[name].channels["position"] - laid["position"]).max() < 0.01 * way
        assert np.array_equal(runs[name].channels["drive"], laid["drive"])


def followed(course):
    """Voltages of a servo that is told position and speed, at 60 rad/s and within +-12 V."""
    for x, way in zip(course[:-1].tolist(), np.diff(course).tolist(), strict=True):

        def law(part, at, speed, x=x, way=way):
            pull = 3600.0 * (x + part * way - at) + 120.0 * (way / STEP - speed)
            volts = pull * INERTIA * RESISTANCE / CONSTANT + CONSTANT * speed
            return min(max(volts, -VOLTS), VOLTS)

        yield law


def test_another_servo_with_its_voltage_follows_it(planned):
    for name, laid in planned[1][1].items():
        course = laid["position"]
        other = made_of(followed(course), float(course[0]), 20)
        assert np.abs(other - course).max() < 0.05 * np.ptp(course), name


def test_it_begins_at_rest_within_the_way_and_never_needs_more_than_there_is(planned):
    reach, (_, asked) = planned
    more = 0.05 * (reach.high - reach.low)
    for name, laid in asked.items():
        course = laid["position"]
        speed = np.diff(course) / STEP
        # All of the voltage against all of the recorded speed.
        most = CONSTANT * (VOLTS + CONSTANT * np.abs(speed).max()) / RESISTANCE + FRICTION
        assert np.abs(np.diff(speed)).max() / STEP * INERTIA <= 1.01 * most, name
        assert abs(speed[0]) <= most / INERTIA * STEP, name
        assert reach.low - more <= course.min() < course.max() <= reach.high + more, name
