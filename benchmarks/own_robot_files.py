"""Recordings of PTER for practice of one's own: plan, effects, sensors, files.

    python benchmarks/own_robot_files.py FOLDER --seed 1 [--only stribeck ...] [--size 1]

Layout, plan, rates, noise and steps as in the shared robot files: eight runs of 6 s from rest.
"""

from __future__ import annotations

import argparse
import zlib
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from own_robot_rig import DURATION, TICK, Truth, integrate

HEADER = (
    "run[1],t[s],command_1[V],command_2[V],command_3[V],command_4[V],"
    "force_x[lbf],force_y[lbf],theta_1[rad],theta_2[rad]"
)
RUNS = 8
#: Effect -> (of clutches "c" or joints "j", size at 1, names that are right).
CLUTCH = {
    "stribeck": (0.35, ("stribeck",)),
    "log_speed": (0.10, ("logarithmic-speed",)),
    "degressive": (0.45, ("degressive-speed", "logarithmic-speed")),
    "asymmetry": (0.10, ("asymmetry",)),
    "position": (0.20, ("position-friction", "position-friction-2")),
    "fade": (0.8, ("thermal-fade",)),
    "wear": (0.35, ("wear-in", "warm-up")),
    "drift": (0.06, ("drift",)),
    "dwell": (0.25, ("dwell-breakaway",)),
    "lag": (0.5, ("time-constant",)),
    "release": (0.8, ("release-asymmetry",)),
    "remanence": (0.5, ("remanence", "play-hysteresis")),
    "hysteresis": (0.5, ("play-hysteresis", "remanence")),
    "pull_in": (0.02, ("pull-in",)),
    "slew": (0.03, ("slew-limit", "slew-limit-2")),
    "second_lag": (0.025, ("second-lag",)),
    "sag": (0.02, ("other-excitations",)),
    "command": (0.12, ("command-scale",)),
}
JOINT = {
    "viscous": ((6.0, 3.0), ("viscous-drag",)),
    "quadratic": ((12.0, 5.0), ("quadratic-drag",)),
    "dry": ((10.0, 6.0), ("dry-drag",)),
    "bias": ((12.0, -7.0), ("bias-force",)),
    "tilt": ((25.0, 10.0), ("tilt",)),
    "spring": ((20.0, 12.0), ("spring-force",)),
    "lengths": ((0.04, -0.05), ("link-lengths",)),
}
OTHERS = {
    "cable": ({"cable": 0.35}, ("tip-spring",)),
    "tip_drag": ({"tip_drag": 0.02}, ("tip-drag",)),
    "payload": ({"payload": 0.035}, ("payload", "inertia")),
    "inertia_1": ({"inertia": (0.15, 0.0, 0.0)}, ("added-inertia", "inertia")),
    "inertia_2": ({"inertia": (0.0, 0.2, 0.0)}, ("added-inertia", "inertia")),
    "gamma": ({"inertia": (0.0, 0.0, 1.5)}, ("inertia",)),
    "force_gain": ({"force_gain": (0.08, 0.03)}, ("force-gain",)),
    "force_turned": ({"turned": 0.08}, ("force-turned",)),
    "force_offset": ({"force_offset": (0.5, -0.35)}, ("force-offset",)),
    "force_delay": ({"delay": 0.03}, ("force-delay",)),
    "angle_gain": ({"angle_gain": (0.04, 0.02)}, ("angle-gain",)),
    "angle_offset": ({"angle_offset": (0.1, 0.0)}, ("angle-offset",)),
    "grip": ({"grip": (0.3, 0.3, 0.3, 0.3)}, ()),
    "detent": ({"detent": (10.0, 6.0)}, ()),
    "null": ({}, ()),
}
#: Clutches 3 and 4 sit side by side; or the first feels the second alone.
BESIDE, ALONE = np.zeros((2, 4, 4))
BESIDE[2, 3], BESIDE[3, 2], ALONE[0, 1] = 0.12, 0.08, 0.15
#: Fields: of the coil with the next number, or of all others.
RING = 0.12 * np.roll(np.eye(4), 1, axis=1)
ALL = 0.05 * (np.ones((4, 4)) - np.eye(4))
FIELDS = ("cross-coupling-fields",)
COUPLED = {
    "beside": ({"leak": BESIDE}, ("cross-coupling",)),
    "alone": ({"leak": ALONE}, ("cross-coupling",)),
    "field_next": ({"field": RING}, ("cross-coupling-next", *FIELDS)),
    "field_all": ({"field": ALL}, ("cross-coupling-others", *FIELDS)),
    "quick_slew": (
        {"slew": np.full(4, 0.014), "lag": np.full(4, -0.45)},
        ("slew-limit", "slew-limit-2"),
    ),
    "weak": ({"weak": (0.2, 0.35, 0.25, 0.3)}, ("torque-scale",)),
    "weak_one": ({"weak": (0.0, 0.35, 0.0, 0.0)}, ("torque-scale",)),
}
#: Made after the others, whose seeds go by their place in the list.
LATER = {
    "force_crosstalk": ({"crosstalk": (0.0, 0.06)}, ("force-crosstalk",)),
}
KINDS = (*CLUTCH, *(f"{k}_one" for k in CLUTCH), *JOINT, *OTHERS, *COUPLED, *LATER)


def right_names(kind: str) -> tuple[str, ...]:
    """Names of the library that a diagnosis should give; none for nulls and what is in no list."""
    plain = kind.removesuffix("_one")
    return (
        CLUTCH[plain][1] if plain in CLUTCH else ({**JOINT, **OTHERS, **COUPLED, **LATER}[kind][1])
    )


def truth(kind: str, size: float, rng: np.random.Generator) -> tuple[Truth, dict]:
    """The hidden truth, and what the sensors do."""
    scale = 1.0 + 0.04 * rng.uniform(-1.0, 1.0, 4)
    plain, vary = kind.removesuffix("_one"), rng.uniform(0.85, 1.15)
    hidden: dict = {}
    if plain in CLUTCH:
        each = rng.uniform(0.8, 1.2, 4) * size * CLUTCH[plain][0]
        if kind.endswith("_one"):
            each = np.where(np.arange(4) == rng.integers(4), 1.5 * each, 0.0)
        hidden = {plain: each}
        if plain == "command":
            hidden["offset"] = 1.5 * each
    elif kind in JOINT:
        hidden = {kind: vary * size * np.array(JOINT[kind][0])}
    else:
        hidden = {
            k: vary * size * (np.array(v) if isinstance(v, tuple) else v)
            for k, v in {**OTHERS, **COUPLED, **LATER}[kind][0].items()
        }
    scale = scale * (1.0 - hidden.pop("weak", 0.0))
    fields = {k: v for k, v in hidden.items() if k in Truth._fields}
    return Truth(scale, **fields), {k: v for k, v in hidden.items() if k not in fields}


def plan(rng: np.random.Generator):
    """Start, commands of every tick, and the path that the hand follows."""
    q0 = np.array([1.2 + rng.uniform(-0.2, 0.2), 2.0 + rng.uniform(-0.2, 0.2)])
    table = np.zeros((int(DURATION * TICK) + 1, 4))
    at, now = int(rng.uniform(0.3, 1.0) * TICK), np.zeros(4)
    while at < len(table):
        for i in range(4):
            if rng.random() < 0.6 or now[i] > 0.0:
                now[i] = rng.uniform(0.6, 7.0) if rng.random() < 0.42 else 0.0
        table[at:] = np.round(now, 3)
        at += int(rng.uniform(0.15, 0.75) * TICK)
    path = np.empty((2, 4, 2))
    path[:, :, 1] = np.array([0.13, 0.29, 0.47, 0.81]) * rng.uniform(0.8, 1.2, (2, 4))
    path[:, :, 0] = np.array([6.0, 4.0, 2.5, 1.0]) * rng.uniform(0.5, 1.3, (2, 4))
    return q0, table, path, rng.uniform(0.0, 2 * np.pi, (2, 4))


def sensed(rows: np.ndarray, table: np.ndarray, s: dict, coloured: bool, rng) -> np.ndarray:
    """Columns of the file but for the run's number."""
    t, angles, force = rows[:, 0], rows[:, 1:3], rows[:, 3:5]
    a = s.get("turned", 0.0)
    force = force @ np.array([[np.cos(a), np.sin(a)], [-np.sin(a), np.cos(a)]])
    x, y = s.get("crosstalk", (0.0, 0.0))
    force = force @ np.array([[1.0, y], [x, 1.0]])
    force = force * (1.0 + np.array(s.get("force_gain", (0.0, 0.0))))
    late = t - s.get("delay", 0.0)
    force = np.column_stack([np.interp(late, t, force[:, k]) for k in range(2)])
    force = force + np.array(s.get("force_offset", (0.0, 0.0)))
    middle = np.array([1.2, 2.0])
    gain = np.array(s.get("angle_gain", (0.0, 0.0)))
    angles = angles + gain * (angles - middle) + np.array(s.get("angle_offset", (0.0, 0.0)))
    force = force + noise(0.05, t.size, coloured, rng)
    angles = angles + noise(4e-4, t.size, coloured, rng)
    # A command shows in the first row at or after its tick.
    ticks = np.floor(t * TICK + 1e-6).astype(int)
    steps = [np.round(force / 0.02) * 0.02, np.round(angles / 5.75e-4) * 5.75e-4]
    return np.column_stack([t, table[ticks], *steps])


def noise(sd: float, size: int, coloured: bool, rng: np.random.Generator) -> np.ndarray:
    """White, or half of it remembered over some 10 ms, of the same deviation."""
    white = rng.normal(0.0, sd, (size, 2))
    if not coloured:
        return white
    slow, keep = np.empty((size, 2)), np.exp(-0.2)
    slow[0] = rng.normal(0.0, sd, 2)
    for k in range(1, size):
        slow[k] = keep * slow[k - 1] + np.sqrt(1.0 - keep**2) * rng.normal(0.0, sd, 2)
    return np.sqrt(0.5) * (white + slow)


def write(
    folder: Path, kind: str, seed: int, size: float = 1.0, coloured: bool = False,
    further: Sequence[tuple] | int = (),
) -> Path:  # fmt: skip
    """One file; the same seed gives the same bytes.

    `further` are plans of runs that come after the usual ones, or how many more of those.
    """
    rng = np.random.default_rng([seed, zlib.crc32(kind.encode())])
    hidden, sensors = truth(kind, size, rng)
    parts = []
    more = [None] * further if isinstance(further, int) else further
    for run, planned in enumerate([*[None] * RUNS, *more]):
        q0, table, path, phase = planned or plan(rng)
        rows = integrate(hidden, q0, table, path, phase)
        seen = sensed(rows, table, sensors, coloured, rng)
        parts.append(np.column_stack([np.full(len(rows), run + 1.0), seen]))
    name = f"{kind}-{seed}{'-coloured' if coloured else ''}{'' if size == 1.0 else f'-{size:g}'}"
    file = folder / f"{name}.csv"
    form = ["%d", "%.3f", *["%.4g"] * 4, "%.4f", "%.4f", "%.6f", "%.6f"]
    np.savetxt(file, np.vstack(parts), form, ",", header=HEADER, comments="")
    return file


def main() -> None:
    """Write files of the kinds asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", nargs="*", default=KINDS)
    parser.add_argument("--size", type=float, default=1.0)
    parser.add_argument("--coloured", action="store_true")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    for kind in args.only:
        write(args.folder, kind, args.seed, args.size, args.coloured)


if __name__ == "__main__":
    main()
