"""Wavelengths of friction and of a force, from the recorded motion alone."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest
from evidence import BEFORE, FLOOR, depends, judged

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.position_waves import strongest_waves, waves_of
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.fitting.fit import Fit
from simpter_hybrid.identification.fitting.fitted_model import Trial, share
from simpter_hybrid.identification.fitting.replay import Replay

STEP, MASS, COULOMB = 2e-3, 2.0, 3.0


def passed(number, friction, force, reach=0.25):
    """A slide moved on a course; the drive is what that takes, exactly."""
    t = STEP * np.arange(5000)
    x = reach * (np.sin(1.7 * t) + 0.3 * np.sin(4.1 * t))
    v = reach * (1.7 * np.cos(1.7 * t) + 0.3 * 4.1 * np.cos(4.1 * t))
    a = -reach * (1.7**2 * np.sin(1.7 * t) + 0.3 * 4.1**2 * np.sin(4.1 * t))
    wave = np.sin(number * x + 0.4)
    drive = MASS * a + COULOMB * np.sign(v) * (1.0 + friction * wave) + force * wave
    return Replay("run", "run", t, {"drive": drive}, {}, notes={"position": x, "speed": v})


def of(wave):
    return np.hypot(wave.cosine, wave.sine), np.arctan2(wave.cosine, wave.sine)


@pytest.mark.parametrize("number", [31.0, 77.7])
def test_friction_that_repeats_along_the_way_is_found_with_its_size_and_phase(number):
    friction, _ = strongest_waves([passed(number, 0.3, 0.0)])
    # A quarter of one wave more in the whole way of 0.6 m; smoothing over 30 ms takes a tenth.
    assert friction.number == pytest.approx(number, abs=0.5 * pi / 0.6)
    size, phase = of(friction)
    assert size == pytest.approx(0.3, rel=0.2)
    assert phase == pytest.approx(0.4, abs=0.6)


def test_a_force_that_repeats_is_found_beside_friction_that_does_not():
    _, force = strongest_waves([passed(50.0, 0.0, 0.6)])
    assert force.number == pytest.approx(50.0, abs=0.5 * pi / 0.6)
    size, _ = of(force)
    assert MASS * size == pytest.approx(0.6, rel=0.2)


def test_a_motion_too_short_for_a_wave_has_none():
    still = passed(31.0, 0.3, 0.0)
    short = Replay(
        "run", "run", still.time[:40], {"drive": still.inputs["drive"][:40]}, {},
        notes={k: x[:40] for k, x in still.notes.items()},
    )  # fmt: skip
    assert strongest_waves([short]) is None


def test_any_wavelength_is_tried_as_a_factor_a_level_and_a_force():
    waves = strongest_waves([passed(5.0, 0.3, 0.0, reach=2.0)])
    assert waves[0].number == pytest.approx(5.0, abs=0.5 * pi / 5.0)
    library = axis_candidates(AxisSizes(1.0, 2.0, 5.0, 4.0, 0.1, True, -2.5, 2.5), (waves,))
    known = {c.name: c for c in library}
    for name in ("position-friction-wave", "surface-wave"):
        assert known[name].family == "position"
        assert known[name].starts[0][-1] == waves[0].number
    assert known["ripple-force-wave"].starts[0][-1] == waves[1].number


def test_fits_begin_at_long_waves_too_which_noisy_accelerations_do_not_tell():
    waves = strongest_waves([passed(50.0, 0.3, 0.0, reach=2.0)])  # 5 m of way
    known = {
        c.name: c
        for c in axis_candidates(AxisSizes(1.0, 2.0, 5.0, 4.0, 0.1, True, -2.5, 2.5), (waves,))
    }
    for name in ("position-friction-wave", "surface-wave"):
        numbers = [start[-1] for start in known[name].starts]
        assert numbers[1] == pytest.approx(2 * pi / 5.0)
        number = known[name].parameters[-1]
        assert number.lower <= 0.5 * min(numbers)
        assert number.upper >= 2.0 * max(numbers)


@pytest.mark.parametrize(("number", "kind"), [(5.0, "form incomplete"), (1.5, "unknown")])
def test_what_does_not_come_again_twice_on_the_way_is_a_wave_only_if_nothing_is_left(number, kind):
    waves = strongest_waves([passed(5.0, 0.3, 0.0, reach=2.0)])  # 5 m of way
    known = {
        c.name: c
        for c in axis_candidates(AxisSizes(1.0, 2.0, 5.0, 4.0, 0.1, True, -2.5, 2.5), (waves,))
    }
    wave = known["position-friction-wave"]
    fit = Fit({"position-friction-wave.number": number}, 0.0, np.empty((0, 0)), np.empty(0))
    one = Trial(wave, fit, 1.2, 0.2, share(BEFORE, 1.2, FLOOR))
    own = depends("force:position", 0.05)
    assert judged([one], [depends("force:position", 0.3)], [own], FLOOR, ratio=BEFORE).kind == kind


def test_what_runs_that_select_show_is_begun_at_as_well():
    parts = {"fit": [passed(31.0, 0.3, 0.0)], "select": [passed(400.0, 0.3, 0.0, reach=0.02)]}
    seen = waves_of(parts)
    known = {
        c.name: c
        for c in axis_candidates(AxisSizes(1.0, 2.0, 0.6, 4.0, 0.1, True, -0.3, 0.3), seen)
    }
    for name in ("position-friction-wave", "surface-wave"):
        numbers = [start[-1] for start in known[name].starts]
        # A quarter of one wave more in the whole way of 0.6 m, or of 0.05 m.
        assert numbers[0] == pytest.approx(31.0, abs=0.5 * pi / 0.6)
        assert numbers[1] == pytest.approx(400.0, abs=0.5 * pi / 0.05)


def test_a_run_without_any_drive_among_driven_ones_is_looked_at_too():
    driven, alone = passed(31.0, 0.3, 0.0), passed(31.0, 0.3, 0.0)
    coasting = replace(alone, inputs={"drive": np.zeros(alone.time.size)})
    assert strongest_waves([driven, coasting]) is not None
