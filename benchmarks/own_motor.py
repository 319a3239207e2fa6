"""A small motor on pulses; duty, supply and motion are logged: what is hidden is asked for.

    python benchmarks/own_motor.py                  # goes on where it was; own_motor.csv, .md
    python benchmarks/own_motor.py --fresh          # rows of other programs are made anew

Independent of simpter_hybrid: Euler's rule in steps of 10 us with a rule for stick of its own, six
runs of 8 s of which two each have the same duties.  Files are made, diagnosed and thrown away.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
from own_one_axis import go_through, written
from own_testbed_physics import njit

HERE = Path(__file__).parent
TABLE = HERE / "own_motor.csv"
#: Steps, rows and levels of the duty [s].
STEP, ROW, LEVEL, LASTS = 1e-5, 0.01, 0.5, 8.0
#: Constant [N m/A], resistance [ohm], inertia [kg m^2], friction, supply [V].
K, R, INERTIA, COULOMB, VISCOUS, SUPPLY = 0.06, 6.0, 2e-4, 0.012, 2e-5, 12.0
#: What the model declares over what is true.
DECLARED = {"inertia": 1.05, "coulomb": 0.95, "viscous": 1.1, "constant": 1.01, "resistance": 0.98}
#: Step of an encoder [rad], of which a part is jitter, and noise of a speed [rad/s].
COUNT, JITTER, RATE = 2 * np.pi / 1440, 3e-4, 0.5
SENSORS = ("encoder", "speed")
RUNS = "AABBCC"
#: What is hidden (SI), and which names are right; none: nobody's list has it.
KINDS: dict[str, tuple[dict[str, float], tuple[str, ...]]] = {
    "null": ({}, ()),
    "coasting": ({"coasting": 0.9}, ("drive-coasting",)),
    "stribeck": ({"rise": 0.5}, ("stribeck", "stribeck-2")),
    "quadratic-drag": ({"quadratic": 6e-7}, ("quadratic-drag",)),
    "dead band": ({"dead": 1.0}, ("drive-deadband",)),
    "cogging": ({"cogs": 4e-3}, ("ripple-force-6", "ripple-force-wave")),
    "lag": ({"lag": 0.03}, ("drive-lag",)),
    "asymmetry": ({"asymmetry": 0.15}, ("asymmetry", "asymmetry-level", "bias-force")),
    "warm winding": ({"warms": 0.0075}, ("winding-heat",)),
    "by-rest": ({"ages": 0.8}, ()),
    "coasting and dead band": (
        {"coasting": 0.9, "dead": 0.8}, ("drive-coasting", "drive-deadband"),
    ),
    "coasting and stribeck": (
        {"coasting": 0.9, "rise": 0.5}, ("drive-coasting", "stribeck", "stribeck-2"),
    ),
    "filtered speed": ({"filtered": 0.02}, ("speed-lag",)),
    "counted speed": ({"counted": 0.03}, ("speed-average",)),
}  # fmt: skip
#: An encoder shows nothing of these.
UNSEEN = {("filtered speed", "encoder"), ("counted speed", "encoder")}
ORDER = (
    "coasting", "rise", "quadratic", "dead", "cogs", "lag", "asymmetry", "warms", "ages",
    "filtered",
)  # fmt: skip
TOLERATED = {
    "inertia": ("device.inertia", 0.1),
    "Coulomb friction": ("clutch.1.torque.coulomb", 0.2),
    "viscous friction": ("clutch.1.torque.viscous", 0.3),
    "motor constant": ("load.1.constant", 0.03),
    "resistance": ("load.1.resistance", 0.1),
}
MODEL = f"""[run]
t_end = "8 s"
[start]
coordinates = ["0 rad"]
[device]
kind = "one-axis"
inertia = "{INERTIA * DECLARED["inertia"]:.6g} kg*m^2"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
[clutch.torque]
kind = "coulomb-viscous"
coulomb = "{COULOMB * DECLARED["coulomb"]:.6g} N*m"
viscous = "{VISCOUS * DECLARED["viscous"]:.6g} N*m*s/rad"
[[loads]]
kind = "voltage-drive"
constant = "{K * DECLARED["constant"]:.6g} N*m/A"
resistance = "{R * DECLARED["resistance"]:.6g} ohm"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "axis-speed-servo"
points = [["0 s", "0 rad/s"], ["1 s", "50 rad/s"]]
proportional = "0.1 V/(rad/s)"
limit = "12 V"
"""
MAP = """[time]
column = "s"
unit = "s"
[runs]
boundaries = ["run"]
experiment = ["kind"]
group = ["kind"]
[channels.duty]
column = "duty"
unit = "1"
sign = 1
role = "input"
held = "after"
[channels.supply]
column = "volts"
unit = "V"
sign = 1
role = "constant"
"""
MOTION = {
    "encoder": f'[channels.position]\ncolumn = "rad"\nunit = "rad"\nstep = "{COUNT!r} rad"\n',
    "speed": '[channels.speed]\ncolumn = "rad_s"\nunit = "rad/s"\n',
}
ABOUT = """# A small motor on pulses (synthetic)

    python benchmarks/own_motor.py

Verdicts on recordings of `own_motor.py`: duties that change every half second, read every 10 ms
beside an encoder of 1440 counts or a noisy speed; each course was driven twice. In brackets the
error after over the floor on the runs that select. `by-rest` (more friction for a tenth of a radian
after every reversal) is in nobody's list: right is "unknown". A filtered speed is behind a lag of
20 ms, a counted one the mean of the last 30 ms.
"""


@njit(cache=True)
def turned(duty, coasting, rise, quadratic, dead, cogs, lag, asymmetry, warms, ages, filtered):
    """Angle and speed at every row, and the speed behind a filter (rows, 3)."""
    rows = np.empty((duty.size, 3))
    angle = speed = given = heat = went = shown = 0.0
    gone = 1e9
    for k in range(duty.size):
        rows[k, 0], rows[k, 1], rows[k, 2] = angle, speed, shown
        for _ in range(round(ROW / STEP)):
            told = duty[k] * SUPPLY
            given = given + STEP / lag * (told - given) if lag > 0.0 else told
            acts = given - min(max(given, -dead), dead)
            closed = 1.0 - coasting * (1.0 - min(abs(given) / SUPPLY, 1.0))
            warm = R * (1.0 + warms * heat)
            current = (acts - closed * K * speed) / warm
            heat += STEP * current * current * warm
            level = COULOMB * (1.0 + rise * np.exp(-((speed / 8.0) ** 2)))
            drag = VISCOUS * speed + quadratic * speed * abs(speed)
            free = speed + STEP / INERTIA * (K * current - cogs * np.sin(6.0 * angle) - drag)
            way = speed if speed != 0.0 else free
            level *= 1.0 + ages * np.exp(-(gone if way * went >= 0.0 else 0.0) / 0.1)
            level *= 1.0 + (asymmetry if way > 0.0 else -asymmetry)
            most = STEP * level / INERTIA
            after = 0.0 if abs(free) <= most else free - np.sign(free) * most
            # It has turned round, however long it stood.
            gone = 0.0 if after * went < 0.0 else gone + STEP * abs(after)
            went = after if after != 0.0 else went
            angle += 0.5 * STEP * (speed + after)
            speed = after
            shown = shown + STEP / filtered * (speed - shown) if filtered > 0.0 else speed
    return rows


def counted(angle: np.ndarray, time: float) -> np.ndarray:
    """Mean speed (rows,) over so long a time before each row [rad/s]; before all it has rested."""
    rows = round(time / ROW)
    return (angle - np.concatenate([np.full(rows, angle[0]), angle[:-rows]])) / time


def write(folder: Path, kind: str, sensor: str, seed: int) -> tuple[Path, Path, Path]:
    """Recording, model and map; labelled synthetic by their names."""
    hidden = KINDS[kind][0]
    generator = np.random.default_rng([seed, list(KINDS).index(kind), SENSORS.index(sensor)])
    lines = ["run,kind,s,duty,volts," + ("rad" if sensor == "encoder" else "rad_s")]
    courses = {}
    for name in dict.fromkeys(RUNS):
        levels = generator.uniform(0.2, 1.0, round(LASTS / LEVEL))
        signs = generator.choice([-1.0, 1.0], levels.size)
        courses[name] = np.repeat(np.round(signs * levels, 2), round(LEVEL / ROW))
    for run, name in enumerate(RUNS):
        rows = turned(courses[name], *(hidden.get(size, 0.0) for size in ORDER))
        if sensor == "encoder":
            noisy = rows[:, 0] + JITTER * generator.standard_normal(len(rows))
            seen = COUNT * np.floor(noisy / COUNT)
        else:
            time = hidden.get("counted", 0.0)
            speed = counted(rows[:, 0], time) if time else rows[:, 2]
            seen = speed + RATE * generator.standard_normal(len(rows))
        lines += [
            f"{run + 1},{name},{ROW * k:.2f},{duty:.2f},{SUPPLY:g},{value:.6f}"
            for k, (duty, value) in enumerate(zip(courses[name], seen, strict=True))
        ]
    described = MAP + MOTION[sensor] + 'sign = 1\nrole = "measured"\nmay_rest = true\n'
    return written(folder, "motor", lines, MODEL, TOLERATED, described)


if __name__ == "__main__":
    go_through(write, TABLE, ABOUT, KINDS, SENSORS, seeds=2, unseen=UNSEEN)
