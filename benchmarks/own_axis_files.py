"""Recordings of a mass on a slide that hide what is asked for, independent of simpter_hybrid.

Steps of 20 us with a rule for stick of its own; six trials of 8 s, a force of five sines, rows of
2 ms.  What is logged: positions with noise, positions of an encoder, or positions and speeds; or
the positions are taken as what moves the slide and the force as what that takes ("moved"); or a
servo follows five sines, and its set points are logged and no force ("set points"); or what a
driver was told is logged in place of a force ("told").

    python benchmarks/own_axis_files.py DIR --kind stribeck --sensor encoder --seed 7
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path

import numpy as np
from own_testbed_physics import njit
from scipy.signal import lfilter

MASS, COULOMB, STEP, ROW, LENGTH = 2.0, 3.0, 2e-5, 2e-3, 8.0
#: Largest force [N]; noise of force [N], position [m] and speed [m/s]; step of the encoder [m].
PUSH, FORCE_NOISE, NOISE, SPEED_NOISE, ENCODER = 14.0, 0.01, 3e-6, 1e-3, 1e-5
SENSORS = ("positions", "encoder", "speeds", "moved", "set points", "told")
#: Of the servo: gains [N/m, N s/m], limit [N], time between samples [s]; largest set point [m].
STIFF, DAMP, LIMIT, TICK, REACH = 1500.0, 50.0, 25.0, 1e-3, 0.06
#: What is hidden (strengths in SI), and which names are right; none: nobody's list has it.
KINDS: dict[str, tuple[dict[str, float], tuple[str, ...]]] = {
    "null": ({}, ()),
    "viscous-drag": ({"viscous": 4.0}, ("viscous-drag",)),
    "quadratic-drag": ({"quadratic": 12.0}, ("quadratic-drag",)),
    "asymmetry": ({"asymmetry": 0.2}, ("asymmetry", "bias-force")),
    "stribeck": ({"stribeck": 0.25}, ("stribeck", "stribeck-2")),
    "spring": ({"spring": 30.0}, ("spring-force",)),
    "added-mass": ({"mass": 0.5}, ("added-inertia", "force-gain")),
    "by-position": ({"wave": 0.3}, ("position-friction-wave", "surface-wave")),
    "by-time": ({"fades": 0.25}, ("drift", "settling")),
    "presliding": ({"bristle": 3e-4}, ("presliding", "presliding-2")),
    "by-rest": ({"ages": 0.4}, ()),
    # A force sensor with six times the noise, 2 % of the friction; and with noise of 10 ms, 1 %.
    "null, noisy force": ({"force_noise": 0.06}, ()),
    "stribeck, noisy force": (
        {"stribeck": 0.25, "force_noise": 0.06},
        ("stribeck", "stribeck-2"),
    ),
    "null, slow noise": ({"force_noise": 0.03, "slow": 0.01}, ()),
    # What the force sensor does wrong: it shows 30 % more (12 % a refit of the mass, declared to
    # 5 %, does as well), 6 ms late, or through a lag of 8 ms.
    "force-gain": ({"shows": 0.3}, ("force-gain", "added-inertia")),
    "force-delay": ({"late": 0.006}, ("force-delay",)),
    "force-lag": ({"lags": 0.008}, ("force-lag",)),
    # A force that repeats along the way (a screw's, a motor's poles).
    "ripple": ({"ripple": 0.6}, ("ripple-force-wave",)),
    # Friction that falls with the speed and a drag: each hides the other.
    "stribeck and drag": (
        {"stribeck": 0.25, "viscous": 4.0},
        ("stribeck-viscous", "stribeck-viscous-2", "stribeck", "stribeck-2", "viscous-drag"),
    ),
    # The same slow noise where every push is given twice.
    "null, slow noise, repeated": ({"force_noise": 0.03, "slow": 0.01, "repeated": 1}, ()),
    "stribeck, slow noise, repeated": (
        {"stribeck": 0.25, "force_noise": 0.03, "slow": 0.01, "repeated": 1},
        ("stribeck", "stribeck-2"),
    ),
    "by-rest, slow noise, repeated": (
        {"ages": 0.4, "force_noise": 0.03, "slow": 0.01, "repeated": 1},
        (),
    ),
    # Friction that is another in each trial (3 %), alone and beside an effect.
    "friction of each run": ({"differs": 0.03}, ()),
    "stribeck, friction of each run": (
        {"stribeck": 0.25, "differs": 0.03},
        ("stribeck", "stribeck-2"),
    ),
    "by-time, friction of each run": ({"fades": 0.25, "differs": 0.03}, ("drift", "settling")),
    # A driver that does what it is told 7 ms later, through a lag of 8 ms, or less 0.6 N.
    "drive-delay": ({"waits": 0.007}, ("drive-delay",)),
    "drive-lag": ({"follows": 0.008}, ("drive-lag",)),
    "drive-deadband": ({"dead": 0.6}, ("drive-deadband",)),
    "drive-delay and drag": ({"waits": 0.007, "viscous": 4.0}, ("drive-delay", "viscous-drag")),
    # A rubber buffer, met 10 mm from where the slide began.
    "buffer": ({"buffer": 60.0}, ("end-spring-high",)),
    # A fifth of the mass on a spring, at 6.5 Hz.
    "flexible": ({"hung": 0.4}, ("flexible-mode",)),
    # Friction that holds the more the longer it has rested, met by ramps after rests.
    "ageing": ({"aged": 0.05, "rests": 1}, ("dwell-breakaway",)),
}
#: Keys of those that are of the sensor or the plan: nothing is hidden by them.
SENSOR = ("force_noise", "slow", "repeated", "rests")
#: Keys of those that a record of set points has not: it has no sensor of force.
OF_FORCE = ("force_noise", "shows", "late", "lags", "rests")
#: Keys of those of a driver; and all else that is made where one was told.
OF_DRIVER, OF_TOLD = ("waits", "follows", "dead"), ("null", "stribeck", "presliding")
ORDER = (
    "viscous", "quadratic", "asymmetry", "stribeck", "spring", "mass", "wave", "fades", "bristle",
    "ages", "ripple", "level", "waits", "follows", "dead", "buffer", "hung",
    "aged",
)  # fmt: skip


@njit(cache=True)
def slide(
    force, every, servo, viscous, quadratic, asymmetry, stribeck, spring, mass, wave, fades,
    bristle, ages, ripple, level_change, waits, follows, dead, buffer, hung,
    aged,
):  # fmt: skip
    """Positions and speeds at every so many steps; `force` is that, or what a servo follows."""
    rows = np.empty((len(force) // every, 2))
    told, driven, tick, wait = np.zeros(len(force)), 0.0, round(TICK / STEP), round(waits / STEP)
    x, v, z, way, gone, rested = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    rate, stretch, pace = 2.0 * np.pi * 6.5, 0.0, 0.0
    moved = MASS + mass - hung
    for i in range(len(force) // every * every):
        if i % every == 0:
            rows[i // every, 0], rows[i // every, 1] = x, v
        if not servo:
            told[i] = force[i]
        elif i % tick == 0:
            told[i : i + tick] = min(LIMIT, max(-LIMIT, STIFF * (force[i] - x) - DAMP * v))
        given = told[i - wait] if i >= wait else 0.0
        given -= min(dead, max(-dead, given))
        driven = given if follows == 0.0 else driven + STEP / follows * (given - driven)
        push = driven - viscous * v - quadratic * v * abs(v) - spring * x
        push -= buffer * max(x - 0.01, 0.0)
        push += ripple * np.sin(140.0 * x + 0.4)
        if hung > 0.0:
            drawn = rate * (rate * stretch + 0.06 * (pace - v))
            push, pace = push + hung * drawn, pace - STEP * drawn
            stretch += STEP * (pace - v)
        ahead = v + STEP * push / moved
        level = COULOMB * (1.0 + level_change) * (1.0 + stribeck * np.exp(-abs(v) / 0.03))
        level *= (1.0 + wave * np.sin(60.0 * x)) * (1.0 - fades * i * STEP / LENGTH)
        level *= 1.0 + (asymmetry if ahead > 0.0 else -asymmetry)
        if v * way < 0.0:  # it has turned round, however long it stood
            gone = 0.0
        way, gone = v if v != 0.0 else way, gone + STEP * abs(v)
        level *= 1.0 + ages * np.exp(-(gone if ahead * way >= 0.0 else 0.0) / 0.01)
        if bristle > 0.0:  # a bristle that bends and yields, its bend with an exponent
            z += STEP * v / bristle * (1.0 - np.sign(z * v) * abs(z) ** 1.4)
            before, v = v, ahead - STEP * level * z / moved
            x += STEP * (0.5 * (before + v) if servo else v)
            continue
        most, before = STEP * level / moved, v
        rested = rested + STEP if v == 0.0 else 0.0
        holds = most * (1.0 + aged * np.log1p(rested / 0.05))
        v = 0.0 if abs(ahead) <= holds else ahead - np.sign(ahead) * most
        # The end of a step for all of it is early by half a step: 3 um at 0.3 m/s.  Windows do not
        # see that, a whole run does.
        x += STEP * (0.5 * (before + v) if servo else v)
    return rows


def pushes(generator: np.random.Generator) -> np.ndarray:
    """A force of five sines that begins gently [N]."""
    time = np.arange(round(LENGTH / STEP)) * STEP
    frequency, phase = generator.uniform(0.3, 3.0, 5), generator.uniform(0.0, 2 * np.pi, 5)
    size = generator.uniform(0.5, 1.0, 5)
    waves = [
        a * np.sin(2 * np.pi * f * time + p)
        for a, f, p in zip(PUSH * size / size.sum(), frequency, phase, strict=True)
    ]
    return np.sum(waves, axis=0) * np.minimum(1.0, time / 0.5)


def ramps(generator: np.random.Generator) -> np.ndarray:
    """A force that rises to and fro after rests of 0.1 to 2.5 s [N]."""
    parts, way = [], 1.0
    while sum(map(len, parts)) < round(LENGTH / STEP):
        rest, rise, back = generator.uniform([0.1, 0.2, 0.1], [1.0, 0.5, 0.3])
        top, way = generator.uniform(1.4, 1.9) * COULOMB, -way
        rest = 2.5 * rest**2
        spans = [round(part / STEP) for part in (rest, rise, back)]
        parts += [np.zeros(spans[0]), np.linspace(0.0, way * top, spans[1]), np.zeros(spans[2])]
    return np.concatenate(parts)[: round(LENGTH / STEP)]


def noise_of_force(
    generator: np.random.Generator, count: int, hidden: Mapping[str, float]
) -> np.ndarray:
    """White, or with the memory `slow` [s], of the same deviation [N]."""
    white = hidden.get("force_noise", FORCE_NOISE) * generator.standard_normal(count)
    if "slow" not in hidden:
        return white
    kept = np.exp(-ROW / hidden["slow"])
    return lfilter([np.sqrt(1.0 - kept**2)], [1.0, -kept], white)


def shown(force: np.ndarray, hidden: Mapping[str, float]) -> np.ndarray:
    """What a sensor without noise shows of a force given every `STEP`."""
    late, kept = round(hidden.get("late", 0.0) / STEP), 0.0
    if "lags" in hidden:
        kept = np.exp(-STEP / hidden["lags"])
    seen = np.concatenate([np.zeros(late), force[: force.size - late]])
    return (1.0 + hidden.get("shows", 0.0)) * lfilter([1.0 - kept], [1.0, -kept], seen)


def make(kind: str, sensor: str, seed: int) -> str:
    """A CSV of six trials."""
    hidden: dict[str, float] = dict(KINDS[kind][0])
    generator = np.random.default_rng([seed, list(KINDS).index(kind), SENSORS.index(sensor)])
    servo, every = sensor == "set points", round(ROW / STEP)
    lines = ["trial,kind,time_ms,slide_mm," + ("wanted_mm" if servo else "load_N")]
    lines[0] += ",rate_mm_s" if sensor == "speeds" else ""
    for trial in range(6):
        if trial % 2 == 0 or "repeated" not in hidden:
            force = ramps(generator) if "rests" in hidden else pushes(generator)
            if servo:
                force = REACH / PUSH * force
            if servo or sensor == "told":  # a set point, a force told, a row
                force = np.repeat(force[::every], every)
        if "differs" in hidden:
            hidden["level"] = hidden["differs"] * generator.standard_normal()
        rows = slide(force, every, servo, *(hidden.get(name, 0.0) for name in ORDER))
        x, v = rows[:, 0], rows[:, 1] + SPEED_NOISE * generator.standard_normal(len(rows))
        if sensor == "encoder":
            x = ENCODER * np.round(x / ENCODER)
        else:
            x = x + NOISE * generator.standard_normal(len(x))
        if servo or sensor == "told":
            load = (1e3 if servo else 1.0) * force[::every]
        else:
            load = shown(force, hidden)[::every] + noise_of_force(generator, len(x), hidden)
        for k in range(len(x)):
            line = f"{trial + 1},{'ABC'[trial // 2]},{1e3 * ROW * k:.0f},{1e3 * x[k]:.5f}"
            last = f",{1e3 * v[k]:.4f}" if sensor == "speeds" else ""
            lines.append(f"{line},{load[k]:.4f}{last}")
    return "\n".join(lines) + "\n"


def write(folder: Path, kind: str, sensor: str, seed: int) -> tuple[Path, Path, Path]:
    """Recording, model and map, as docs/diagnose.md has them; labelled synthetic by their names."""
    page = (Path(__file__).parent.parent / "docs" / "diagnose.md").read_text(encoding="utf-8")
    model, map_text = (part.partition("```")[0] for part in page.split("```toml\n")[1:3])
    if sensor == "speeds":
        map_text += '[channels.speed]\ncolumn = "rate_mm_s"\nunit = "mm/s"\nsign = 1\n'
        map_text += 'role = "measured"\n'
    if sensor == "encoder":
        map_text = map_text.replace("may_rest = true", 'may_rest = true\nstep = "0.01 mm"')
    if sensor == "moved":
        motion, force = map_text.split("[channels.force]")
        motion = motion.replace('role = "measured"', 'role = "input"')
        force = force.replace('role = "input"', 'role = "measured"')
        map_text = f"{motion}[channels.force]{force}"
    if sensor == "told":
        map_text = map_text.replace("[channels.force]", "[channels.drive]")
        map_text += 'held = "after"\n'
    if sensor == "set points":
        gains = {"2 kHz": "1 kHz", "100 V/m": f"{STIFF:g} V/m", "20 V*s/m": f"{DAMP:g} V*s/m"}
        for old, new in {**gains, "10 V": f"{LIMIT:g} V"}.items():
            model = model.replace(f'"{old}"', f'"{new}"')
        motion = map_text.partition("[channels.force]")[0]
        wanted = 'column = "wanted_mm"\nunit = "mm"\nsign = 1\nrole = "input"\nheld = "after"\n'
        map_text = f"{motion}[channels.reference]\n{wanted}"
    files = folder / "synthetic_slide.csv", folder / "slide.toml", folder / "slide_map.toml"
    for file, text in zip(files, (make(kind, sensor, seed), model, map_text), strict=True):
        file.write_text(text, encoding="utf-8")
    return files


def main() -> None:
    """Write one recording with its model and map."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--kind", choices=KINDS, default="null")
    parser.add_argument("--sensor", choices=SENSORS, default="positions")
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    for file in write(args.folder, args.kind, args.sensor, args.seed):
        print(file)


if __name__ == "__main__":
    main()
