"""A pendulum let go by hand, of which only the motion is logged: what is hidden is asked for.

    python benchmarks/own_pendulum.py               # goes on where it was; own_pendulum.csv, .md
    python benchmarks/own_pendulum.py --fresh       # rows of other programs are made anew

Independent of simpter_hybrid: steps of 0.1 ms by Heun's rule with a rule for stick of its own, six
swings of 10 s from other angles, none repeated.  Files are made, diagnosed and thrown away.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from own_one_axis import go_through, written
from own_testbed_physics import njit

HERE = Path(__file__).parent
TABLE = HERE / "own_pendulum.csv"
STEP, LASTS = 1e-4, 10.0
#: True values; declared are 0.02, 0.6, 0.006 and 0.0012.
INERTIA, WEIGHT, COULOMB, VISCOUS = 0.0204, 0.6, 0.0065, 0.0013
#: Angles of release [deg] of kinds A (fitted), B (select), C (held out).
RELEASED = (("A", 60.0), ("A", -50.0), ("B", 75.0), ("B", -35.0), ("C", 70.0), ("C", -45.0))
#: Time between rows [s], noise of the angle [rad] and its step, noise of a speed [rad/s] or none.
SENSORS = {
    "film": (0.01, np.radians(0.1), 0.0, 0.0),
    "encoder": (0.002, 0.0, np.radians(360.0 / 8192), 0.0),
    "gyroscope": (0.005, np.radians(0.1), 0.0, 0.01),
}
#: What is hidden (SI), and which names are right; none: nobody's list has it.
KINDS: dict[str, tuple[dict[str, float], tuple[str, ...]]] = {
    "null": ({}, ()),
    "quadratic-drag": ({"quadratic": 8e-4}, ("quadratic-drag",)),
    "stribeck": ({"stribeck": 0.6}, ("stribeck", "stribeck-2")),
    "asymmetry": ({"asymmetry": 0.2}, ("asymmetry", "asymmetry-level", "bias-force")),
    "by-angle": ({"wave": 0.4}, ("position-friction-2", "position-friction-wave", "surface-wave")),
    "by-time": ({"fades": 0.3}, ("drift", "settling")),
    "by-rest": ({"ages": 0.8}, ()),
    "catch": ({"catch": 0.012}, ()),
}
ORDER = ("quadratic", "stribeck", "asymmetry", "wave", "fades", "ages", "catch")
#: Where the catch draws to, and how near it does so [rad].
CAUGHT, NEAR = 0.3, 0.06
MODEL = """[run]
t_end = "10 s"
[start]
coordinates = ["60 deg"]
[device]
kind = "one-axis"
inertia = "0.02 kg*m^2"
weight = "0.6 N*m"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "0.006 N*m", viscous = "0.0012 N*m*s/rad" }
"""
TOLERATED = {
    "inertia": ("device.inertia", 0.05),
    "Coulomb friction": ("clutch.1.torque.coulomb", 0.4),
    "viscous friction": ("clutch.1.torque.viscous", 0.5),
}
MAP = """driven = false
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["swing"]
experiment = ["kind"]
group = ["kind"]
[split]
fit = ["kind A"]
select = ["kind B"]
report = ["kind C"]
"""
ANGLE = '[channels.position]\ncolumn = "deg"\nunit = "deg"\nsign = 1\nrole = "measured"\n'
SPEED = '[channels.speed]\ncolumn = "rad_s"\nunit = "rad/s"\nsign = 1\nrole = "measured"\n'
ABOUT = """# A pendulum let go (synthetic)

    python benchmarks/own_pendulum.py

Verdicts on recordings of `own_pendulum.py`, which nothing drives and of which the motion alone is
logged; in brackets the error after over the floor on the swings that select. `by-rest` (more
friction for a tenth of a radian after every reversal) and `catch` (a magnet draws to one angle) are
in nobody's list: right is "unknown".
Friction that differs with direction, a constant force and a weight that hangs askew are the same in
a swing, and move where it rests; of a gyroscope the speed alone is compared, which does not see it.
"""


@njit(cache=True)
def swung(angle, quadratic, stribeck, asymmetry, wave, fades, ages, catch):
    """Angle and speed (steps, 2)."""
    rows = np.empty((round(LASTS / STEP), 2))
    speed, gone, went = 0.0, 0.0, 0.0
    for i in range(len(rows)):
        rows[i, 0], rows[i, 1] = angle, speed
        level = COULOMB * (1.0 + stribeck * np.exp(-abs(speed) / 0.5))
        level *= (1.0 + wave * np.cos(2.0 * angle - 0.7)) * (1.0 - fades * i * STEP / LASTS)
        way = speed if speed != 0.0 else -np.sin(angle)
        level *= 1.0 + ages * np.exp(-(gone if way * went >= 0.0 else 0.0) / 0.1)
        level *= 1.0 + (asymmetry if way > 0.0 else -asymmetry)
        free = speed
        for k in range(2):  # the speed ahead without friction, its rates at both ends
            at, v = angle + k * STEP * speed, speed if k == 0 else free
            drag = VISCOUS * v + quadratic * v * abs(v)
            away = (at - CAUGHT) / NEAR
            drawn = catch * away * np.exp(0.5 - 0.5 * away * away)
            rate = -(WEIGHT * np.sin(at) + drag + drawn) / INERTIA
            free = speed + STEP * rate if k == 0 else 0.5 * (free + speed + STEP * rate)
        most = STEP * level / INERTIA
        after = 0.0 if abs(free) <= most else free - np.sign(free) * most
        # It has turned round, however long it stood.
        gone = 0.0 if after * went < 0.0 else gone + STEP * abs(after)
        went = after if after != 0.0 else went
        angle += 0.5 * STEP * (speed + after)
        speed = after
    return rows


def write(folder: Path, kind: str, sensor: str, seed: int) -> tuple[Path, Path, Path]:
    """Recording, model and map; labelled synthetic by their names."""
    hidden, row = KINDS[kind][0], SENSORS[sensor][0]
    _, noise, step, noise_of_speed = SENSORS[sensor]
    generator = np.random.default_rng([seed, list(KINDS).index(kind), list(SENSORS).index(sensor)])
    lines = ["swing,kind,s,deg" + (",rad_s" if noise_of_speed else "")]
    for swing, (of, released) in enumerate(RELEASED):
        first = np.radians(released + generator.normal(0.0, 2.0))
        rows = swung(first, *(hidden.get(name, 0.0) for name in ORDER))[:: round(row / STEP)]
        angle = rows[:, 0] + noise * generator.standard_normal(len(rows))
        if step:
            angle = step * np.round(angle / step)
        speed = rows[:, 1] + noise_of_speed * generator.standard_normal(len(rows))
        for k, (q, v) in enumerate(zip(np.degrees(angle), speed, strict=True)):
            last = f",{v:.5f}" if noise_of_speed else ""
            lines.append(f"{swing + 1},{of},{row * k:.3f},{q:.6f}{last}")
    known = f'step = "{360.0 / 8192!r} deg"\n' if step else ""
    described = MAP + ANGLE + "may_rest = true\n" + known
    described += SPEED + "may_rest = true\n" if noise_of_speed else ""
    return written(folder, "pendulum", lines, MODEL, TOLERATED, described)


if __name__ == "__main__":
    go_through(write, TABLE, ABOUT, KINDS, SENSORS, seeds=2)
