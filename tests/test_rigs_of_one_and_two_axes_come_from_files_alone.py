"""Servos, pendulums and testers written in TOML, against closed forms and balances."""

from math import cos, exp, pi, sin

import numpy as np
import pytest

from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample

FRICTION = """
threshold = "-1 V"
time_constant = "0 s"
delay = "0 s"
[{name}.torque]
kind = "coulomb-viscous"
"""

AXIS = '[run]\nt_end = "{t_end}"\n[device]\nkind = "one-axis"\ninertia = "0.02 kg*m^2"\n{device}'
START = '[start]\ncoordinates = ["{q} rad"]\nspeeds = ["{qd} rad/s"]\n[clutch]'


def axis(t_end="1 s", device="", q=0.0, qd=0.0, friction='coulomb = "0 N*m"\n', rest=""):
    head = AXIS.format(t_end=t_end, device=device) + START.format(q=q, qd=qd)
    return simulate(parse(head + FRICTION.format(name="clutch") + friction + rest))


def test_a_pendulum_with_joint_friction_stops_where_gravity_cannot_move_it():
    run = axis(
        "20 s", 'weight = "2 N*m"\nhanging = "0.3 rad"\n', 1.5, friction='coulomb = "0.1 N*m"\n'
    )
    assert run.status == "finished"
    assert energy_balance(run).relative < 1e-8
    assert run.mode[-1, 0] == 0
    assert 0.0 < 2.0 * abs(sin(run.end[0] - 0.3)) <= 0.1
    lost = 2.0 * (cos(run.end[0] - 0.3) - cos(1.2))
    assert run.end[-1] == pytest.approx(lost, rel=1e-8)


DRIVE = """[[loads]]
kind = "voltage-drive"
constant = "0.4 N*m/A"
resistance = "4 ohm"
[controller]
rate = "200 Hz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "100 rad"]]
proportional = "1 V/rad"
limit = "6 V"
release = "0.8 s"
"""


def test_a_saturated_motor_runs_up_to_its_no_load_speed_and_coasts_when_released():
    run = axis(rest=DRIVE)
    lag = 0.02 * 4.0 / 0.4**2
    at_release = 6.0 / 0.4 * (1.0 - exp(-0.8 / lag))
    assert run.end[1] == pytest.approx(at_release, rel=1e-9)
    assert run.state(0.5, "left")[1] == pytest.approx(15.0 * (1.0 - exp(-0.5 / lag)), rel=1e-9)


def test_a_motor_of_so_many_newtons_an_ampere_runs_a_slide_up_to_its_no_load_speed():
    head = AXIS.replace("one-axis", "linear-axis").replace("0.02 kg*m^2", "2 kg")
    head = head.replace("inertia", "mass").format(t_end="0.8 s", device="")
    start = START.replace("rad", "m").format(q=0.0, qd=0.0)
    drive = DRIVE.replace("0.4 N*m/A", "40 N/A").replace("V/rad", "V/m").replace("rad", "m")
    text = head + start + FRICTION.format(name="clutch") + 'coulomb = "0 N"\n' + drive
    run, lag = simulate(parse(text)), 2.0 * 4.0 / 40.0**2
    fastest = 6.0 / 40.0
    assert run.state(0.01, "left")[1] == pytest.approx(fastest * (1 - exp(-0.01 / lag)), rel=1e-9)
    assert run.end[1] == pytest.approx(fastest, rel=1e-9)


SPEED = """[[loads]]
kind = "force-drive"
constant = "1 N*m/V"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "axis-speed-servo"
points = [["0 s", "2 rad/s"]]
proportional = "1 V*s/rad"
integral_gain = "20 V/rad"
"""


def test_a_speed_loop_with_an_integral_holds_its_speed_against_friction():
    run = axis("1.5 s", friction='coulomb = "0.3 N*m"\nviscous = "0.1 N*m*s/rad"\n', rest=SPEED)
    # The slowest pole is near integral over proportional gain, 18 1/s: exp(-27) is left.
    assert run.end[1] == pytest.approx(2.0, abs=1e-8)
    assert sample(run, [1.499]).tau[0, 0] == pytest.approx(-0.5, abs=1e-8)


TABLE = """
[run]
t_end = "0.6 s"
[device]
kind = "linear-axis"
mass = "95 kg"
[start]
coordinates = ["0 m"]
[clutch]{friction}
coulomb = "20 N"
viscous = "200 N*s/m"
[[loads]]
kind = "force-drive"
constant = "35 N/V"
[[effects]]
kind = "asymmetry"
clutch = 1
share = 0.1
[[effects]]
kind = "bias-force"
coordinate = "slide"
bias = "-3 N"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 m"], ["1 s", "0.1 m"]]
proportional = "39000 V/m"
derivative = "243 V*s/m"
differenced = 1
limit = "10 V"
"""


def test_a_positioning_table_follows_its_reference_behind_by_what_friction_takes():
    scenario = parse(TABLE.format(friction=FRICTION.format(name="clutch")))
    run = simulate(scenario)
    late = sample(run, [0.55])
    # At constant speed the drive gives friction and bias; the loop's error gives the drive.
    force = 1.1 * (20.0 + 200.0 * 0.1) + 3.0
    behind = 0.055 - late.q[0, 0]
    volts = 39000.0 * behind - 243.0 * 0.1
    assert 35.0 * volts == pytest.approx(force, rel=0.05)  # the sampled loop ripples a little
    assert late.qd[0, 0] == pytest.approx(0.1, rel=1e-3)
    text = resolve(scenario).text
    assert simulate(parse(text)).end.tobytes() == run.end.tobytes()


ARM = """
[run]
t_end = "2 s"
[device]
kind = "two-link"
mass_1 = "0.52 kg"
mass_2 = "0.63 kg"
length_1 = "0.2 m"
centre_1 = "0.2 m"
centre_2 = "0.256 m"
inertia_1 = "0.032 kg*m^2"
inertia_2 = "0.051 kg*m^2"
rotor_1 = "0.002 kg*m^2"
[start]
coordinates = ["1.2 rad", "-0.7 rad"]
[clutch]{friction}
coulomb = "0.05 N*m"
viscous = "0.01 N*m*s/rad"
[[loads]]
kind = "recorded-force"
coordinate = "elbow"
points = [["0 s", "0 N*m"], ["1 s", "1 N*m"], ["2 s", "-1 N*m"]]
"""


def test_a_two_link_arm_keeps_its_energy_ledger_and_sticks_joint_by_joint():
    run = simulate(parse(ARM.format(friction=FRICTION.format(name="clutch"))))
    assert run.status == "finished"
    assert energy_balance(run).relative < 1e-8
    seen = sample(run, np.linspace(0.0, 2.0, 200))
    assert (seen.slip[seen.mode == 0] == 0.0).all()


TESTER = """
[run]
t_end = "1 s"
[device]
kind = "linear-axis"
mass = "1 kg"
[start]
coordinates = ["0 m"]
speeds = ["{speed} m/s"]
commands = ["3 V"]
excitations = ["3 V"]
[clutch]{friction}
coulomb = "5 N"
viscous = "100 N*s/m"
normal = "2 N/V"
[[effects]]
kind = "prescribed-motion"
coordinate = "slide"
points = [{points}]
"""


def test_a_seal_tester_moves_as_prescribed_and_feels_the_friction_of_its_pressure():
    times = np.linspace(0.0, 1.0, 51)
    points = ", ".join(f'["{t!r} s", "{0.02 * sin(2 * pi * t)!r} m"]' for t in times.tolist())
    speed = 0.02 * 2 * pi
    friction = FRICTION.format(name="clutch")
    run = simulate(parse(TESTER.format(points=points, speed=speed, friction=friction)))
    assert run.status == "finished", run.message
    seen = sample(run, times[10:-1])
    # The curve is bent at its points and the loop that holds it smooths that: 1e-6 m; its start,
    # where the slope is known from one side only, is left out.
    assert seen.q[:, 0] == pytest.approx(0.02 * np.sin(2 * pi * times[10:-1]), abs=1e-6)
    force = -np.sign(seen.qd[:, 0]) * (5.0 + 2.0 * 3.0 + 100.0 * abs(seen.qd[:, 0]))
    moving = abs(seen.qd[:, 0]) > 1e-3
    assert seen.tau[moving, 0] == pytest.approx(force[moving], rel=1e-12)
