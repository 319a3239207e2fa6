"""A logged temperature gives an effect by its name; what else was logged gives a curve over it."""

import numpy as np
import pytest
from axis_recordings import written
from moved_axis import MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.reporting.held_out_sentences import held_out
from simpter_hybrid.identification.result import corrected, with_curve
from simpter_hybrid.plots.added import added_terms
from simpter_hybrid.plots.diagnosis import strongest

SPLIT = """
[split]
fit = ["run 0", "run 1", "run 2", "run 3", "run 4", "run 5"]
select = ["run 6", "run 7", "run 8"]
report = ["run 9", "run 10", "run 11"]
[channels.CHANNEL]
column = "y"
unit = "UNIT"
sign = 1
role = "input"
"""
NOISE = 0.05
TIME = np.arange(0.0, 6.0, 0.005)
DECLARED = model(0.3, 'coulomb = "5 N", viscous = "4 N*s/m"')


def _recording(folder, channel, unit, course, change, viscous=1.0):
    """Twelve runs, moved to and fro: friction is changed by what `course` of (run, time) is.

    `viscous`: what is viscous changes by this part of that.
    """
    generator, rows = np.random.default_rng(3), ["run,t,x,F,y"]
    for run in range(12):
        turn = 2 * np.pi * (0.5 + 0.1 * (run % 4))
        x, v = 0.05 * np.sin(turn * TIME + 0.3), 0.05 * turn * np.cos(turn * TIME + 0.3)
        y = course(run, TIME)
        rubs = 5.0 * np.sign(v) * (1.0 + change(y)) + 4.0 * v * (1.0 + viscous * change(y))
        force = -0.3 * turn**2 * x + rubs + generator.normal(0.0, NOISE, TIME.size)
        columns = zip(TIME, x, force, y, strict=True)
        rows += [f"{run},{a:.3f},{b:.8f},{c:.5f},{d:.4f}" for a, b, c, d in columns]
    described = MAP + SPLIT.replace("CHANNEL", channel).replace("UNIT", unit)
    return written(folder, rows, described)


@pytest.mark.slow
def test_friction_by_a_logged_temperature_is_named_and_its_model_lacks_nothing(tmp_path):
    recording = _recording(tmp_path, "temperature", "degC", warming, lambda t: -0.02 * (t - 30.0))
    found = diagnose(recording, parse(DECLARED))
    done = found.search
    assert [e.name for e in done.corrected.effects] == ["friction-by-temperature"]
    (effect,) = corrected(found, "warm").effects
    # At the reference friction is what was refitted: -0.02 of that at 30 degrees.
    there = 1.0 - 0.02 * (effect.reference - 303.15)
    assert effect.change == pytest.approx(-0.02 / there, rel=0.03)
    assert held_out(found) == pytest.approx(1.0, abs=0.05)
    (term,) = added_terms(found)
    assert term.coordinate == "temperature"
    assert strongest(done.rounds[0])[1].coordinate == "temperature"
    assert diagnose(recording, corrected(found, "warm")).search.verdict.kind == "nothing missing"


def warming(run, time):
    """In celsius; every other run cools."""
    return 25.0 + (run * 5) % 12 + (1 - 2 * (run % 2)) * 4.0 * np.sin(0.3 * time)


@pytest.mark.slow
def test_dry_friction_that_changes_alone_is_told_from_what_is_viscous(tmp_path):
    dry = lambda t: -0.02 * (t - 30.0)  # noqa: E731
    recording = _recording(tmp_path, "temperature", "degC", warming, dry, viscous=0.0)
    found = diagnose(recording, parse(DECLARED))
    assert [e.name for e in found.search.corrected.effects] == ["friction-by-temperature-2"]
    dries, thins = corrected(found, "warm").effects
    there = 1.0 - 0.02 * (dries.reference - 303.15)
    assert dries.change == pytest.approx(-0.02 / there, rel=0.03)
    # All friction is drier by the factor: the drag makes up for it.
    assert thins.change == pytest.approx(0.02 / there * 4.0, rel=0.1)
    assert held_out(found) == pytest.approx(1.0, abs=0.05)


@pytest.mark.slow
def test_friction_by_another_channel_gets_a_curve_over_it(tmp_path):
    def of_the_day(run, time):
        return 0.3 + 0.04 * ((run * 5) % 12) + 0.0 * time

    def worse(humidity):
        return 0.4 * np.tanh(4.0 * (humidity - 0.45))

    recording = _recording(tmp_path, "humidity", "1", of_the_day, worse)
    found = diagnose(recording, parse(DECLARED))
    assert found.search.verdict.kind == "unknown"
    assert found.empirical.coordinate == "force:humidity"
    assert held_out(found, "empirical") < 1.2 < 3.0 < held_out(found, "refitted")
    again = diagnose(recording, with_curve(found, "curved"))
    assert again.search.verdict.kind == "nothing missing"
