"""A mass on a spring is let go: in its noisy positions no force shows a bump of friction.

Its energy does: what is lost there is lost for the rest of the run.
"""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.tracing.locating import located
from simpter_hybrid.identification.tracing.traced import of_all_balances

MASS, SPRING, COULOMB, VISCOUS, PLACE, WIDTH = 2.0, 400.0, 0.5, 0.5, 0.018, 0.004
NOISE, STEP, ROW, LASTS = 1e-4, 1e-4, 5e-3, 5.0
SPRUNG = '[[effects]]\nkind = "spring-force"\ncoordinate = "slide"\nstiffness = "400 N/m"\n'
BEFORE, _, AFTER = MODEL.partition("[[loads]]")
DECLARED = parse(
    (BEFORE + SPRUNG + AFTER[AFTER.index("[[tolerances]]") :])
    .replace('"one-axis"', '"linear-axis"').replace('inertia = "0.02 kg*m^2"', 'mass = "2 kg"')
    .replace('weight = "0.5 N*m"\n', "").replace('coordinates = ["0 rad"]', 'coordinates = ["0 m"]')
    .replace("0.2 N*m", "0.5 N").replace("0.02 N*m*s/rad", "0.5 N*s/m")
)  # fmt: skip
LET_ALONE = "driven = false\n" + MAP.partition("[channels.torque]")[0].replace('"deg"', '"mm"')


def released(first, rise):
    """Places (samples,) by small steps; friction stops it where it can."""
    at, speed, places = first, 0.0, []
    for _ in range(round(LASTS / STEP)):
        places.append(at)
        level = COULOMB * (1.0 + rise * np.exp(-0.5 * ((at - PLACE) / WIDTH) ** 2))
        push = -SPRING * at
        way = np.sign(speed) or np.sign(push) * (abs(push) > level)
        after = speed + STEP * (push - VISCOUS * speed - way * level) / MASS
        speed = 0.0 if after * way <= 0.0 and abs(push) <= level else after
        at += STEP * speed
    return np.array(places)[:: round(ROW / STEP)]


def recorded(folder, rise):
    generator, rows = np.random.default_rng(7), ["take,ms,angle"]
    for run, first in enumerate((0.06, -0.055, 0.045, -0.06)):
        seen = released(first, rise)
        seen = seen + NOISE * generator.standard_normal(seen.size)
        rows += [f"{run},{1e3 * ROW * k:.0f},{-1e3 * x:.4f}" for k, x in enumerate(seen)]
    split = 'fit = ["take 0", "take 3"]'
    return written(folder, rows, LET_ALONE.replace('fit = ["take 0"]', split))


@pytest.mark.parametrize("rise", [0.0, pytest.param(0.8, marks=pytest.mark.slow)])
def test_the_position_is_told_and_the_curve_lowers_the_error_of_other_runs(tmp_path, rise):
    found = diagnose(recorded(tmp_path, rise), DECLARED, ())
    done = found.search
    if not rise:
        assert (done.verdict.kind, found.empirical) == ("nothing missing", None)
        return
    assert done.verdict.kind == "unknown"
    assert located(of_all_balances(done.rounds[0].before)) == ()
    assert done.verdict.coordinates[0] == "force:position"
    assert found.error_by_stage["empirical"] < 0.5 * found.error_by_stage["after"]
    # Knots are 20 mm apart, so that the curve spreads the bump over one.
    places, values = found.empirical.drawn()
    assert abs(places[np.argmax(values)] - PLACE) < 2 * WIDTH
