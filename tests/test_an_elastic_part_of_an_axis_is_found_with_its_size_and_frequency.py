"""A slide of two masses on a spring, simulated by small steps; the model knows of one."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of

MASS, PART, FREQUENCY, DAMPING, COULOMB = 2.0, 0.4, 7.0, 0.02, 3.0
NOISE, STEP, ROW, LASTS = 2e-6, 1e-4, 2e-3, 6.0
DECLARED = parse(
    MODEL.replace('"one-axis"', '"linear-axis"').replace('inertia = "0.02 kg*m^2"', 'mass = "2 kg"')
    .replace('weight = "0.5 N*m"\n', "").replace('coordinates = ["0 rad"]', 'coordinates = ["0 m"]')
    .replace("0.2 N*m", "3 N").replace("0.02 N*m*s/rad", "0 N*s/m").replace("N*m/V", "N/V")
    .replace('["1 s", "1 rad"]', '["1 s", "1 m"]').replace('"0 rad"', '"0 m"')
    .replace("V/rad", "V/m")
)  # fmt: skip
TOLD = MAP.partition("[channels.torque]")[0].replace('"deg"', '"mm"').replace("-1", "1")
TOLD += '[channels.force]\ncolumn = "push"\nunit = "N"\nsign = 1\nrole = "input"\n'
TRIED = ("flexible-mode", "stribeck", "viscous-drag", "force-lag", "added-inertia")


def moved(part, phase):
    """Force and place (rows, 2) of a slide of which `part` [kg] hangs on a spring."""
    time = STEP * np.arange(round(LASTS / STEP))
    waves = ((5.0, 0.6), (4.0, 1.3), (4.0, 2.7))
    force = sum(a * np.sin(2 * np.pi * f * time + phase * f) for a, f in waves)
    force *= np.minimum(1.0, time / 0.3)
    rate, own = 2 * np.pi * FREQUENCY, MASS - part
    at = speed = stretch = pace = 0.0
    rows = np.empty((time.size, 2))
    for k, push in enumerate(force.tolist()):
        rows[k] = push, at
        drawn = rate * (rate * stretch + 2 * DAMPING * (pace - speed))
        free, level = speed + STEP * (push + part * drawn) / own, STEP * COULOMB / own
        after = 0.0 if abs(free) <= level else free - np.sign(free) * level
        pace -= STEP * drawn
        stretch += STEP * (pace - after)
        at, speed = at + 0.5 * STEP * (speed + after), after
    return rows[:: round(ROW / STEP)]


def found(folder, part):
    generator, rows = np.random.default_rng(3), ["take,ms,angle,push"]
    for run, phase in enumerate((0.3, 1.1, 2.3)):
        for k, (push, at) in enumerate(moved(part, phase)):
            seen, told = 1e3 * at, push + 0.01 * generator.standard_normal()
            seen += 1e3 * NOISE * generator.standard_normal()
            rows.append(f"{run},{1e3 * ROW * k:.0f},{seen:.5f},{told:.4f}")
    recording = written(folder, rows, TOLD)
    bench = bench_of(recording, DECLARED, groups_of(recording))
    return diagnose(recording, DECLARED, [c for c in bench.candidates if c.name in TRIED])


@pytest.mark.slow
def test_it_is_named_with_its_numbers(tmp_path):
    done = found(tmp_path, PART).search
    assert done.verdict.kind == "effect"
    assert [e.name for e in done.corrected.effects] == ["flexible-mode"]
    # Steps of 0.1 ms are early by half of one: 0.2 % of a swing, and of all that it does.
    assert done.corrected.values["flexible-mode.mass"] == pytest.approx(PART, rel=0.03)
    assert done.corrected.values["flexible-mode.frequency"] == pytest.approx(FREQUENCY, rel=0.01)


@pytest.mark.slow
def test_of_one_mass_it_is_not(tmp_path):
    done = found(tmp_path, 0.0).search
    assert (done.verdict.kind, done.corrected.effects) == ("nothing missing", ())
