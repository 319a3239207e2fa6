"""[readings] in a scenario file: what its sensors would have read, in readings.csv."""

import csv

import numpy as np
import pytest

from simpter_hybrid import api
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.measuring.readings import force_axes, read, signals
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.problems import InvalidInput

#: A rotor that coasts against 0.5 N m: 3 rad/s, -5 rad/s^2.
FILE = """
name = "coasting"
[run]
t_end = "0.4 s"
[device]
kind = "testbed"
inertia = "0.1 kg*m^2"
[start]
coordinates = ["0.2 rad"]
speeds = ["3 rad/s"]
[clutch]
threshold = "-1 V"
time_constant = "0 s"
delay = "0 s"
torque = { kind = "coulomb-viscous", coulomb = "0.5 N*m" }
[readings]
rate = "1 kHz"
"""
SENSOR = '[[readings.sensors]]\nsignal = "%s"\n'


def angle(t):
    return 0.2 + 3.0 * t - 2.5 * t * t


def test_readings_are_the_signal_as_the_sensors_numbers_say():
    text = FILE + SENSOR % "rotor" + 'gain = 0.1\noffset = "-0.05 rad"\ndelay = "10 ms"\n'
    text += SENSOR % "torque of clutch 1" + SENSOR % "speed of rotor" + 'step = "0.01 rad/s"\n'
    run = simulate(parse(text))
    times, values = read(run, run.scenario.notes["readings"])
    assert times == pytest.approx(np.arange(401) * 1e-3, abs=1e-15)
    expected = 1.1 * angle(np.maximum(times - 0.01, 0.0)) - 0.05
    # Solver tolerance 1e-10 a step.
    assert values[:, 0] == pytest.approx(expected, abs=1e-9)
    assert values[1:, 1] == pytest.approx(-0.5, abs=1e-12)
    assert abs(values[:, 2] - (3.0 - 5.0 * times)).max() <= 0.005 + 1e-9


def test_a_differentiated_potentiometer_shows_its_noise_over_the_interval():
    noise = 'noise = "1e-4 rad"\nseed = 3\ndifferentiated = true\n'
    run = simulate(parse(FILE + SENSOR % "rotor" + noise))
    times, values = read(run, run.scenario.notes["readings"])
    rest = values[2:, 0] - (3.0 - 5.0 * (times[2:] - 5e-4))
    # Standard deviation sqrt(2) 1e-4/1e-3; of 399 correlated numbers good to some per cent.
    assert rest.std() == pytest.approx(2.0**0.5 * 0.1, rel=0.15)


def test_the_same_seed_gives_the_same_bytes_whatever_is_read_beside_it(tmp_path):
    noisy = SENSOR % "rotor" + 'noise = "1e-3 rad"\nseed = 5\n'
    alone = api.run(parse(FILE + noisy))
    beside = api.run(parse(FILE + noisy + SENSOR % "slip of clutch 1"))
    columns = []
    for name, run in (("alone", alone), ("beside", beside), ("again", alone)):
        api.save(run, tmp_path / name)
        with (tmp_path / name / "readings.csv").open(newline="") as stream:
            columns.append([row[:2] for row in csv.reader(stream)])
    assert columns[0] == columns[1] == columns[2]
    assert columns[0][0] == ["t [s]", "rotor [rad]"]


def test_readings_are_written_back_and_read_again():
    text = FILE + SENSOR % "rotor" + 'noise = "1e-3 rad"\nclock_shift = "-2 ms"\nseed = 5\n'
    scenario = parse(text)
    resolved = resolve(scenario).text
    assert resolve(parse(resolved)).text == resolved
    assert parse(resolved).notes["readings"] == scenario.notes["readings"]


def test_what_is_wrong_with_sensors_comes_out_at_once():
    wrong = (
        FILE.replace("1 kHz", "1 s")
        + 'force_turned = "0.1 rad"\n'
        + "force_crosstalk = [0.1, 0.0]\n"
        + SENSOR % "elbow"
        + 'nois = "1 rad"\n'
    )
    wrong += SENSOR % "rotor" + 'noise = "1 N"\ndelay = "-1 s"\n'
    with pytest.raises(InvalidInput) as found:
        parse(wrong)
    base = "readings.sensors"
    keys = {"readings.rate", "readings.force_turned", "readings.force_crosstalk",
            f"{base}.0.signal", f"{base}.0.nois", f"{base}.1.noise", f"{base}.1.delay"}  # fmt: skip
    assert {p.path for p in found.value.problems} == keys


def test_a_device_with_a_tip_has_it_among_its_signals():
    device = api.load("line-y24").device
    assert {"tip x", "tip y", "torque of clutch 4"} <= signals(device).keys()


def test_the_force_on_a_tip_and_the_friction_of_all_clutches_can_be_read():
    run = simulate(api.load("line-y24"))
    found = sample(run, np.linspace(0.1, 0.9, 5))
    known = signals(run.scenario.device)
    force = np.column_stack([known[f"tip force {axis}"].column(found) for axis in "xy"])
    friction = [known[f"friction on {name}"].column(found) for name in ("theta_1", "theta_2")]
    device, jacobian = run.scenario.device, [0.0] * 4
    for k, q in enumerate(found.q.tolist()):
        device.tip_jacobian(q, list(device.parameters().values()), jacobian)
        # The hand is all that pushes: its generalized force is J^T times the force on the tip.
        pushed = np.reshape(jacobian, (2, 2)).T @ force[k]
        assert pushed == pytest.approx(found.load[k], rel=1e-12)
        assert abs(force[k]).max() > 0.0
    # Clutches 1 and 2 brake the links, 3 their difference, 4 their sum.
    tau = found.tau.T
    assert friction[0] == pytest.approx(tau[0] + tau[2] + tau[3], rel=1e-12)
    assert friction[1] == pytest.approx(tau[1] - tau[2] + tau[3], rel=1e-12)
    turned = signals(run.scenario.device, force_axes(0.3))
    shown = [turned[f"tip force {axis}"].column(found) for axis in "xy"]
    expected = (force[:, 0] + 1j * force[:, 1]) * np.exp(0.3j)
    assert shown[0] + 1j * shown[1] == pytest.approx(expected, rel=1e-12)
