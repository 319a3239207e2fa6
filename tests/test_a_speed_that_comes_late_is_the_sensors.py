"""A speed that is filtered, delayed or a mean over a while: shown so, begun right, asked for."""

from functools import partial

import numpy as np
import pytest
from axis_recordings import MAP, MODEL, SPEED, declared_axis, recorded_axis

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.speed_sensor import (
    AVERAGE,
    DELAY,
    LAG,
    SENSOR,
    begun_right,
    shown_speed,
)
from simpter_hybrid.identification.axis.windows import BENT_ROWS
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.result import corrected
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.sensor import Sensor

TIME = 0.002 * np.arange(500)
ERRORS = [({LAG: 0.015}, Sensor(filter=0.015)), ({DELAY: 0.012}, Sensor(delay=0.012)),
          ({AVERAGE: 0.02}, Sensor(average=0.02)),
          ({AVERAGE: 0.012, LAG: 0.006}, Sensor(average=0.012, filter=0.006))]  # fmt: skip
LATE = {"speed-lag", "speed-delay", "speed-average", "speed-average-lag"}


def course(t):
    """A speed that swings [rad/s], from long before the record on."""
    return 3.0 + 4.0 * np.sin(9.0 * t)


def rises(t):
    """Its acceleration [rad/s2]."""
    return 36.0 * np.cos(9.0 * t)


def shown(sensor, time=TIME):
    """What a sensor shows of it, settled."""
    before = np.arange(-250, 0) * 0.002
    return sensor.read(np.concatenate([before, time]), course)[before.size :]


def replay(sensor, time=TIME):
    """A run with two windows, begun as the sensor shows it."""
    seen = shown(sensor, time)
    notes = {"speed": seen, BENT_ROWS: np.zeros(time.size, bool), "start": np.array([0.0, seen[0]])}
    anew = (Restart(250, 1.0, float(seen[250])),)
    observed = {"speed": Observation(seen, 0.01, time >= 0.0)}
    return Replay("run", "run", time, {}, observed, anew, notes=notes)


@pytest.mark.parametrize(("values", "sensor"), ERRORS)
def test_a_model_that_moves_so_is_shown_so_in_every_window(values, sensor):
    # Before a window the speed is taken for straight: of its bend (324 rad/s3 at most) a mean over
    # 20 ms sees 324 * 0.02^2 / 12 = 0.011 rad/s, a delay of 12 ms up to 324 * 0.012^2 / 8.
    found = shown_speed(replay(sensor), course(TIME), rises(TIME), values)
    assert found == pytest.approx(shown(sensor), abs=0.02)


@pytest.mark.parametrize(("values", "sensor"), ERRORS)
def test_so_it_is_where_rows_are_not_evenly_spaced(values, sensor):
    uneven = np.cumsum(np.tile([0.001, 0.003], 250))
    found = shown_speed(replay(sensor, uneven), course(uneven), rises(uneven), values)
    assert found == pytest.approx(shown(sensor, uneven), abs=0.02)  # as above


@pytest.mark.parametrize(("values", "sensor"), ERRORS)
def test_a_window_begins_as_fast_as_the_axis_was(values, sensor):
    run = begun_right(replay(sensor), values)
    # A cubic over 31 rows of 2 ms; a mean is half its time late but for 324 * 0.02^2 / 24.
    assert run.restarts[0].speed == pytest.approx(course(TIME[250]), abs=0.02)
    # From one side a parabola tells it worse; uncorrected it would be 0.36 to 0.54 rad/s off.
    assert run.notes["start"][1] == pytest.approx(course(0.0), abs=0.1)


def test_what_shows_at_once_is_left_as_it_is():
    run = replay(Sensor())
    assert begun_right(run, {LAG: 0.0, DELAY: 0.0}) is run
    assert np.array_equal(shown_speed(run, course(TIME), rises(TIME), {}), course(TIME))


def tried(folder, described):
    recorded_axis(folder, [], rate_noise=0.01)
    (folder / "map.toml").write_text(described, encoding="utf-8")
    recording = as_recorded(load_recording(folder / "data.csv", folder / "map.toml"))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    return {c.name: c for c in bench.candidates if c.name in LATE}


def without(text, channel):
    """A map less one of its channels."""
    first, _, rest = text.partition(f"[channels.{channel}]")
    return first + rest[rest.index("[channels") :]


def test_it_is_asked_of_a_speed_that_was_logged_alone(tmp_path, monkeypatch):
    monkeypatch.setattr("axis_recordings.MODEL", declared_text())
    asked = tried(tmp_path, without(MAP + SPEED, "position"))
    assert asked.keys() == LATE
    assert "position logged beside" in asked["speed-lag"].experiment


def declared_text():
    """The axis without a weight, which a place would be needed for."""
    return MODEL.replace('weight = "0.5 N*m"\n', "")


def test_not_beside_a_position_that_it_goes_with(tmp_path):
    assert not tried(tmp_path, MAP + SPEED)


def test_but_beside_one_that_it_is_behind(tmp_path):
    asked = tried(tmp_path, MAP + SPEED + 'clock_shift = "20 ms"\n')
    assert asked.keys() == LATE
    assert "without its speed" in asked["speed-lag"].experiment  # a position is there


def test_not_of_an_axis_that_is_let_alone(tmp_path):
    alone = "driven = false\n" + without(MAP + SPEED, "torque")
    assert not tried(tmp_path, alone)


def test_a_declared_one_that_is_ahead_is_refused():
    sensor = '{ signal = "speed of joint", clock_shift = "5 ms" }'
    ahead = f'[readings]\nrate = "1 kHz"\nsensors = [{sensor}]\n'
    with pytest.raises(InvalidInput, match="a speed that is ahead cannot be taken into account"):
        AxisRig().declared_sensor_errors(parse(MODEL + ahead))


def logged_late(folder, sensor):
    """Three takes of the axis whose speed was logged by such a sensor, and nothing else of it."""
    recorded_axis(folder, [], rate_noise=1e-6)
    head, *lines = (folder / "data.csv").read_text(encoding="utf-8").splitlines()
    rows = np.array([[float(x) for x in line.split(",")] for line in lines])
    for take in np.unique(rows[:, 0]):
        own = rows[:, 0] == take
        time, rate = 1e-3 * rows[own, 1], rows[own, 4]
        # Its drive has jumped where a take begins: nothing was before.
        rows[own, 4] = sensor.read(time, partial(np.interp, xp=time, fp=rate), int(take))
    text = "\n".join([head, *(",".join(f"{x:.8g}" for x in row) for row in rows)])
    (folder / "data.csv").write_text(text, encoding="utf-8")
    (folder / "map.toml").write_text(without(MAP + SPEED, "position"), encoding="utf-8")
    return as_recorded(load_recording(folder / "data.csv", folder / "map.toml"))


def diagnosed(recording, declared):
    bench = bench_of(recording, declared, groups_of(recording))
    asked = LATE | {"drive-lag", "force-delay", "force-lag", "stribeck", "viscous-drag"}
    tried = tuple(c for c in bench.candidates if c.name in asked)
    return diagnose(recording, declared, candidates=tried)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "field"), [("speed-lag", "filter"), ("speed-average", "average")])
def test_a_model_with_what_was_found_lacks_nothing(tmp_path, monkeypatch, name, field):
    monkeypatch.setattr("axis_recordings.MODEL", declared_text())
    recording = logged_late(tmp_path, Sensor(**{field: 0.02}, noise=0.01, seed=3))
    found = diagnosed(recording, declared_axis())
    assert name in {e.name for e in found.search.corrected.effects}
    # Hundreds of rows of a few rad/s in noise of 0.01.
    assert found.search.corrected.values[SENSOR[field]] == pytest.approx(0.02, rel=0.05)
    again = diagnosed(recording, corrected(found, "corrected"))
    assert again.search.verdict.kind == "nothing missing"
