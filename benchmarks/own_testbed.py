"""Recordings of a testbed that hide what is asked for, independent of simpter_hybrid.

    python benchmarks/own_testbed.py DIR --seed 1 --effects stribeck=1 imbalance=0.6
    python benchmarks/own_testbed.py DIR --seed 2 --noise coloured --batteries poor

writes NAME.csv.gz, with the columns of the recordings under SIMPTER_DATA/testbed, and beside it
NAME.truth.json.  The same arguments give the same bytes.
"""

from __future__ import annotations

import argparse
import gzip
import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from own_testbed_effects import KINDS, declared_departures, hidden_fields
from own_testbed_motion import run
from own_testbed_physics import Numbers
from own_testbed_plan import ROW, Planned, battery, poor_battery
from scipy.signal import lfilter

MOTOR = "motor_torque[lbf*in]"
COLUMNS = (
    "battery[1]", "run[1]", "t[s]", "mode[1]", "ref[rad/s or lbf*in]", "command[V]",
    "neighbour_command[V]", MOTOR, "clutch_torque[lbf*in]", "speed[rad/s]", "angle[rad]",
)  # fmt: skip
#: Standard deviation of the noise and step, as the recordings' README states them.
MOTOR_NOISE, TORQUE_NOISE, SPEED_NOISE = 3.0, 2.0, 0.010
TORQUE_STEP, SPEED_STEP, ANGLE_STEP = 0.84, 0.0085, 2 * np.pi / 16384
#: Scatter of breakaway, relative.
SCATTER = 0.01
#: Coloured noise: this part of the variance has this correlation time [s]; the rest is white.
COLOURED, MEMORY = 0.6, 0.02
#: More rests than any run has.
RESTS = 512


def draws(seed: int) -> tuple[np.random.Generator, ...]:
    """Independent streams: departures, plan, noise, hidden states."""
    children = np.random.SeedSequence(seed).spawn(4)
    return tuple(np.random.default_rng(c) for c in children)


def noise(rng: np.random.Generator, size: int, kind: str) -> np.ndarray:
    """Noise of unit standard deviation."""
    white = rng.standard_normal(size)
    if kind == "white":
        return white
    keep = np.exp(-ROW / MEMORY)
    driven = np.sqrt(1 - keep**2) * rng.standard_normal(size)
    driven[0] = rng.standard_normal()
    slow = lfilter([1.0], [1.0, -keep], driven)
    return np.sqrt(1 - COLOURED) * white + np.sqrt(COLOURED) * slow


def measured(true: np.ndarray, rng: np.random.Generator, kind: str) -> np.ndarray:
    """What the logger keeps of a run's motor torque, clutch torque, speed and angle."""
    sizes = (MOTOR_NOISE, TORQUE_NOISE, SPEED_NOISE)
    steps = (TORQUE_STEP, TORQUE_STEP, SPEED_STEP)
    kept = [
        step * np.round((true[:, k] + sd * noise(rng, len(true), kind)) / step)
        for k, (sd, step) in enumerate(zip(sizes, steps, strict=True))
    ]
    return np.column_stack([*kept, ANGLE_STEP * np.round(true[:, 3] / ANGLE_STEP)]) + 0.0


def by_run(numbers: Numbers, rng: np.random.Generator) -> Numbers:
    """A hidden state of a run's own, the same in a repetition with the same commands."""
    level, phase = rng.standard_normal(), rng.uniform(0, 2 * np.pi)
    return numbers._replace(hidden=numbers.hidden * level, wander_phase=float(phase))


def text(group: int, number: int, plan: Planned, kept: np.ndarray, motor: str = "logged") -> str:
    """Rows of one run; the motor torque is ``logged``, ``blank`` or ``absent``."""
    columns = slice(0, 4) if motor == "logged" else slice(1, 4)
    time = ROW * np.arange(1, len(kept) + 1)
    mode = int(plan.torque_mode)
    rows = []
    inputs = zip(time, plan.reference, plan.command, plan.neighbour, strict=True)
    for (t, ref, command, other), values in zip(inputs, kept[:, columns].tolist(), strict=True):
        begin = f"{group},{number},{t:.3f},{mode},{ref:.4g},{command:.4g},{other:.4g},"
        begin += "," if motor == "blank" else ""
        rows.append(begin + ",".join([*(f"{v:.6g}" for v in values[:-1]), f"{values[-1]:.10g}"]))
    return "\n".join(rows) + "\n"


def rounded(plan: Planned) -> Planned:
    """Inputs as they are logged: the rig gets what the file says."""
    digits = np.vectorize(lambda x: float(f"{x:.4g}"), otypes=[float])
    return Planned(plan.torque_mode, *(digits(x) for x in plan[1:]))


def make(
    seed: int,
    effects: Mapping[str, float] | None = None,
    noise: str = "white",
    batteries: str = "rich",
    further: Sequence[Planned] = (),
) -> tuple[str, dict]:
    """A recording and its truth.

    Parameters
    ----------
    seed : int
    effects : mapping of str to float, optional
        Strength by name (`own_testbed_effects.KINDS`).
    noise : str
        ``white`` or ``coloured``.
    batteries : str
        ``rich``: four of eleven runs; ``poor``: ten one-way runs each, motor torque not logged.
    further : sequence of Planned
        Runs that are made after all others, one more in each battery; both torques are logged in
        them.

    Returns
    -------
    str, dict
        The CSV file's text; what it hides.

    Raises
    ------
    ValueError
        If an effect, a noise or a kind of batteries is not known.
    """
    effects = dict(effects or {})
    unknown = [name for name in effects if name not in KINDS]
    if unknown or noise not in ("white", "coloured") or batteries not in ("rich", "poor"):
        raise ValueError(f"not known: {unknown or noise or batteries}; effects are {list(KINDS)}")
    poor = batteries == "poor"
    departing, planning, noisy, hiding = draws(seed)
    fields = declared_departures(departing) | hidden_fields(effects, departing)
    numbers = Numbers(**fields)
    first, *others = [(poor_battery if poor else battery)(planning) for _ in range(3)]
    states = [by_run(numbers, hiding) for _ in range(3 * len(first))]
    out = io.StringIO()
    unlogged = ("blank" if further else "absent") if poor else "logged"
    out.write(",".join(c for c in COLUMNS if not (unlogged == "absent" and c == MOTOR)) + "\n")

    def make_runs(group: int, runs: Sequence[Planned], before: int, hidden, motor: str) -> None:
        for number, asked in enumerate(runs, before + 1):
            plan = rounded(asked)
            chances = SCATTER * noisy.standard_normal(RESTS)
            true = run(*plan, chances, hidden[number - before - 1])
            kept = measured(true, noisy, noise)
            out.write(text(group + 1, number, plan, kept, motor))

    for group, runs in enumerate([first, first, *others]):
        make_runs(group, runs, 0, states[max(group - 1, 0) * len(first) :], unlogged)
    for group in range(4):
        make_runs(group, further, len(first), [numbers] * len(further), "logged")
    names = {name: list(KINDS[name].names) for name in effects}
    truth = {
        "seed": seed, "effects": effects, "noise": noise, "batteries": batteries,
        "fields": fields, "names": names,
        "depends": {name: list(KINDS[name].depends) for name in effects},
    }  # fmt: skip
    return out.getvalue(), truth


def write(folder: Path, name: str, content: str, truth: dict) -> Path:
    """Both files; no dates in them."""
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{name}.csv.gz"
    with file.open("wb") as raw, gzip.GzipFile("", "wb", 3, raw, mtime=0) as packed:
        packed.write(content.encode())
    (folder / f"{name}.truth.json").write_text(json.dumps(truth, indent=1) + "\n", encoding="utf-8")
    return file


def main() -> None:
    """One recording."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--effects", nargs="*", default=[], help="name=strength")
    parser.add_argument("--noise", default="white", choices=("white", "coloured"))
    parser.add_argument("--batteries", default="rich", choices=("rich", "poor"))
    args = parser.parse_args()
    parts = (word.partition("=") for word in args.effects)
    effects = {name: float(strength or 1.0) for name, _, strength in parts}
    name = "-".join([*effects] or ["null"]) + f"-{args.seed}"
    print(write(args.folder, name, *make(args.seed, effects, args.noise, args.batteries)))


if __name__ == "__main__":
    main()
