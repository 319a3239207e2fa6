"""A driver that opens the motor's ends at a duty of zero, and shorts them else."""

from dataclasses import replace
from math import exp

import numpy as np
import pytest
from axis_recordings import written
from motor_by_voltage import FRICTION, MAP, MODEL, SUPPLY, J, K, R

from simpter_hybrid.effects.drive_released import DriveReleased
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor

RELEASED = MAP + '[channels.torque_on]\ncolumn = "on"\nunit = "1"\nsign = 1\nrole = "input"\n'


def driven(folder, share, least=0.0, described=MAP):
    """Three takes of duties that fall to `least` again; a `share` of the back-EMF goes at 0."""
    generator, step, rows = np.random.default_rng(3), 0.01, ["take,s,rate,duty,supply,on"]
    for take in range(3):
        levels = generator.permutation([0.5, 0.6, 0.7, 0.8, 0.9, 1.0])
        duties = np.concatenate([np.r_[np.full(25, u), np.full(15, least)] for u in levels])
        speed = 80.0
        for k, duty in enumerate(duties):
            seen = speed + generator.normal(0.0, 0.2)
            rows.append(f"{take},{k * step:.2f},{seen:.3f},{duty},{SUPPLY},{int(duty > 0.0)}")
            brake = (1.0 - share * (duty == 0.0)) * K * K / R
            acts = K * duty * SUPPLY / R - FRICTION
            gone = exp(-brake / J * step)
            speed = speed * gone + acts * ((1.0 - gone) / brake if brake > 0.0 else step / J)
    return written(folder, rows, described)


def tried(recording, declared):
    recording = as_recorded(recording)
    bench = bench_of(recording, declared, groups_of(recording))
    return {c.name: c for c in bench.candidates}


@pytest.mark.slow
def test_it_is_named_and_the_corrected_model_lacks_nothing(tmp_path):
    recording = driven(tmp_path, 1.0)
    done = diagnose(recording, parse(MODEL)).search
    assert [e.name for e in done.corrected.effects] == ["drive-released"]
    # The noise of 0.2 rad/s on some 270 rows leaves a per cent of it.
    assert done.corrected.values["drive-released.share"] == pytest.approx(1.0, abs=0.03)
    corrected = done.corrected.predictor.scenario(done.corrected.values)
    assert diagnose(recording, corrected).search.verdict.kind == "nothing missing"


def test_one_that_shorts_the_motor_at_once_lacks_nothing(tmp_path):
    assert diagnose(driven(tmp_path, 0.0), parse(MODEL)).search.verdict.kind == "nothing missing"


def test_it_is_asked_only_where_nobody_said_and_nothing_is_told_in_motion(tmp_path):
    declared = parse(MODEL)
    assert "drive-released" in tried(driven(tmp_path, 1.0), declared)
    assert "drive-released" not in tried(driven(tmp_path, 1.0, described=RELEASED), declared)
    assert "drive-released" not in tried(driven(tmp_path, 1.0, least=0.2), declared)
    known = replace(declared, effects=(DriveReleased(coordinate=0, share=1.0),))
    assert "drive-released" not in tried(driven(tmp_path, 1.0), known)


def test_it_does_not_go_with_pulses_between_which_the_ends_are_open(tmp_path):
    declared = replace(parse(MODEL), loads=(replace(parse(MODEL).loads[0], supply=SUPPLY),))
    both = tried(driven(tmp_path, 1.0), declared)
    model = ScenarioPredictor(declared, AxisRig())
    for first, other in (
        ("drive-released", "drive-coasting"),
        ("drive-coasting", "drive-released"),
    ):
        assert model.combines(both[first])
        assert not model.extended(both[first]).combines(both[other])
