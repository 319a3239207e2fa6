"""Recordings of an axis that nobody has written code for, in its own units."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

import numpy as np

from simpter_hybrid.compiled import simulate
from simpter_hybrid.effect import Effect
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.recordings.recording import Recording, load_recording
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.loads.recorded_force import RecordedForce
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

MODEL = """
[run]
t_end = "4 s"
[device]
kind = "one-axis"
inertia = "0.02 kg*m^2"
weight = "0.5 N*m"
[start]
coordinates = ["0 rad"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", coulomb = "0.2 N*m", viscous = "0.02 N*m*s/rad" }
[[loads]]
kind = "force-drive"
constant = "1 N*m/V"
[controller]
rate = "500 Hz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 rad"], ["1 s", "1 rad"]]
proportional = "1 V/rad"
limit = "1 V"
[[tolerances]]
name = "Coulomb friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.2
"""
MAP = """
[time]
column = "ms"
unit = "ms"
[runs]
boundaries = ["take"]
group = ["take"]
[split]
fit = ["take 0"]
select = ["take 1"]
report = ["take 2"]
[channels.position]
column = "angle"
unit = "deg"
sign = -1
role = "measured"
may_rest = true
[channels.torque]
column = "torque"
unit = "lbf*in"
sign = 1
role = "input"
"""
#: The beginning of a map of takes that are let alone, by stamps in seconds.
LET_ALONE = """
driven = false
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["take"]
"""
SPEED = """
[channels.speed]
column = "rate"
unit = "rad/s"
sign = -1
role = "measured"
"""
#: Lines of three takes of nothing in particular, as that map has them.
ROWS = ["take,ms,angle,torque", *(f"{n},{k},{k % 7},{k % 5}" for n in range(3) for k in range(60))]
NEWTON_METRES = 0.1129848290276167
#: When the rows of `recorded_axis` are [s].
TIMES = np.arange(0.0, 4.0, 0.004)


def written(folder: Path, rows: Sequence[str], described: str) -> Recording:
    """A recording of these lines and its map, in `folder`."""
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(described, encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


def declared_axis() -> Scenario:
    """What is known of it."""
    return parse(MODEL)


def recorded_axis(
    folder: Path,
    effects: Sequence[Effect],
    rate_noise: float | None = None,
    shown: Callable[[np.ndarray], np.ndarray] = lambda drive: drive,
    drive: str = "torque",
    friction: Sequence[float] = (1.0, 1.0, 1.0),
    inertia: Sequence[float] = (1.0, 1.0, 1.0),
) -> Recording:
    """Three takes of 4 s with what the declared model lacks; two files in `folder`.

    With `rate_noise` [rad/s] the speed is logged as well.  `shown` is what is logged of the drive;
    ``told`` is one that a driver was told.  `friction` and `inertia` are those of each take, over
    the declared.
    """
    generator = np.random.default_rng(2)
    rows = ["take,ms,angle,torque,rate"]
    for take in range(3):
        moved = _motion(MODEL, tuple(effects), take, friction[take], inertia[take])
        q = moved[0] + generator.normal(0.0, 2e-4, TIMES.size)
        w = moved[1] + generator.normal(0.0, rate_noise or 0.0, TIMES.size)
        rows += [
            f"{take},{1e3 * t:.1f},{-np.degrees(a):.5f},{u / NEWTON_METRES:.6f},{-v:.6f}"
            for t, a, u, v in zip(TIMES, q, shown(_driven(take)), w, strict=True)
        ]
    described = MAP if rate_noise is None else MAP + SPEED
    if drive == "told":
        described = described.replace("channels.torque", "channels.drive")
    return written(folder, rows, described)


def _driven(take: int) -> np.ndarray:
    """Torque on the axis in a take [N m]."""
    return 0.9 * np.sin((2.0 + 0.5 * take) * TIMES) + 0.4 * np.sin(5.3 * TIMES + take)


@lru_cache  # most files ask for the same few
def _motion(
    declared: str, effects: tuple[Effect, ...], take: int, friction: float, inertia: float
) -> np.ndarray:
    """Angles and speeds (2, rows) in a take of an axis with `effects`; to be left as they are."""
    acts = _driven(take)
    load = RecordedForce(tuple(zip(TIMES.tolist(), acts.tolist(), strict=True)), coordinate=0)
    lacking = replace(parse(declared), effects=effects, controllers=())
    own = {"clutch.1.torque.coulomb": 0.2 * friction, "device.inertia": 0.02 * inertia}
    model = with_parameters(lacking, own)
    made = sample(simulate(replace(model, loads=(load,), t_end=4.0)), TIMES)
    return np.array([made.q[:, 0], made.qd[:, 0]])
