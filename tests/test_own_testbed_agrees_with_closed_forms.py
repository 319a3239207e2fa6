"""The independent generator of testbed recordings against what can be worked out by hand."""

import csv
import gzip
import importlib
import math
import os
import sys
from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).resolve().parent.parent


def modules(monkeypatch):
    """The generator's modules, imported anew and forgotten afterwards."""
    monkeypatch.syspath_prepend(str(ROOT / "benchmarks"))
    names = ("physics", "motion", "effects", "plan")
    for name in ("own_testbed", *(f"own_testbed_{n}" for n in names)):
        monkeypatch.delitem(sys.modules, name, raising=False)
    found = {n: importlib.import_module(f"own_testbed_{n}") for n in names}
    yield found | {"files": importlib.import_module("own_testbed")}
    for name in ("own_testbed", *(f"own_testbed_{n}" for n in names)):
        del sys.modules[name]


@pytest.fixture
def bench(monkeypatch):
    """The modules in plain Python: to compile them takes longer than these short runs."""
    monkeypatch.setitem(sys.modules, "numba", None)
    yield from modules(monkeypatch)


@pytest.fixture
def compiled(monkeypatch):
    """The modules as recordings are made by them."""
    pytest.importorskip("numba", reason="a hundred runs take minutes without numba")
    yield from modules(monkeypatch)


def rows(bench, torque_mode, reference, command, seconds, **fields):
    numbers = bench["physics"].Numbers(**fields)
    time = 2e-3 * np.arange(1, round(seconds / 2e-3) + 1)
    given = [np.broadcast_to(np.asarray(x, dtype=float), time.shape) for x in (reference, command)]
    run = bench["motion"].run
    return time, run(torque_mode, *given, np.zeros_like(time), [], numbers)


def test_an_open_clutch_slows_a_spin_as_its_linear_drag_says(bench):
    inertia, push, offset = 0.05, 12.0, 0.9409 * 0.371
    time, out = rows(bench, True, np.r_[np.full(50, push), np.zeros(50)], 0.0, 0.2, inertia=inertia)
    rate = 0.154 * 0.371 / inertia
    steady = (push - offset) / (inertia * rate)
    top = steady * (1 - math.exp(-rate * 0.1))
    rest = -offset / (inertia * rate)
    falling = rest + (top - rest) * np.exp(-rate * (time - 0.1))
    expected = np.where(time <= 0.1 + 1e-9, steady * (1 - np.exp(-rate * time)), falling)
    # The rotor leaves its rest one step of 50 us late.
    assert np.abs(out[:, 2] - expected).max() < 1.5 * 5e-5 * push / inertia


def test_steady_sliding_takes_the_torque_of_equation_39(bench):
    speed, volts = 1.2, 5.0
    _, out = rows(bench, False, speed, volts, 1.2)
    expected = (0.154 * speed + 0.9409) * (6.439 * volts**2 + 0.137 * volts + 0.371)
    assert out[-1, 1] == pytest.approx(expected, rel=1e-5)
    assert out[-1, 0] == pytest.approx(expected, rel=1e-5)


def test_it_breaks_away_at_the_level_of_equation_43(bench):
    volts, slope = 4.0, 200.0
    level = 6.648 * volts**2 + 6.176 * volts + 5.253
    time = 2e-3 * np.arange(1, 851)
    _, out = rows(bench, True, np.where(time > 0.9, slope * (time - 0.9), 0.0), volts, 1.7)
    moving = time[np.argmax(out[:, 2] > 0.0)]
    # A row of the torque and a row of the record.
    assert abs(moving - (0.9 + level / slope)) <= 4e-3
    assert np.all(out[time < moving, 2] == 0.0)


def test_excitation_waits_for_the_delay_and_then_lags(bench):
    volts, speed = 5.0, 1.0
    _, out = rows(bench, False, speed, volts, 0.5)
    at = (0.154 * speed + 0.9409) * (6.439 * volts**2 + 0.137 * volts + 0.371)
    u = volts * (1 - math.exp(-(0.2 - 0.02) / 0.07))
    law = (0.154 * out[99, 2] + 0.9409) * (6.439 * u**2 + 0.137 * u + 0.371)
    assert out[99, 1] == pytest.approx(law, rel=2e-3)  # Euler's rule in steps of 50 us
    assert out[8, 1] < 1.0 < out[14, 1] < at


@pytest.mark.slow
def test_every_effect_changes_the_motion_and_none_spoils_it(compiled):
    rng = np.random.default_rng(3)
    time = 2e-3 * np.arange(1, 751)
    command = np.where(time < 0.8, 6.0, np.where(time < 1.0, 0.0, 7.0))
    neighbour = np.where(time > 0.4, 5.0, 0.0)
    runs = (
        (False, 1.5 * np.sin(2 * np.pi * time / 1.5), command, neighbour),
        (True, 1000.0 * (time % 0.4), np.full(time.shape, 5.0), neighbour),
    )
    run, numbers = compiled["motion"].run, compiled["physics"].Numbers
    plain = [run(*given, [], numbers()) for given in runs]
    for name in compiled["effects"].KINDS:
        fields = compiled["effects"].hidden_fields({name: 1.0}, rng)
        found = [run(*given, [], numbers(**fields)) for given in runs]
        assert np.isfinite(found).all(), name
        assert max(np.abs(a - b).max() for a, b in zip(found, plain, strict=True)) > 1e-3, name


def test_runs_are_laid_out_as_in_the_practice_files(bench):
    data = Path(os.environ.get("SIMPTER_DATA", ROOT.parent / "shared" / "data"))
    practice = data / "testbed" / "practice" / "null.csv.gz"
    if not practice.exists():
        pytest.skip("needs the practice recordings: set SIMPTER_DATA")
    with gzip.open(practice, "rt", encoding="utf-8") as handle:
        assert next(csv.reader(handle)) == list(bench["files"].COLUMNS)
