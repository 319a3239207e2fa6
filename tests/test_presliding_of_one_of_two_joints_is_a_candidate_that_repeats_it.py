"""Friction of one joint that gives way before it slips: its candidate makes the record again."""

from dataclasses import replace

import numpy as np
import pytest
from two_joints import declared_joints, recorded_joints

from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.rigs.pose import slip_travels

DISPLACEMENT = 0.15


def test_it_does_with_its_displacement(tmp_path):
    declared = declared_joints()
    true = replace(declared, effects=(Dahl(clutch=1, displacement=DISPLACEMENT),))
    groups = {"fit": ["run 1"], "select": ["run 2"], "report": ["run 3"]}
    recording = recorded_joints(tmp_path, true, pieces=3)
    groups = dict(zip(groups, ([run.name] for run in recording.runs), strict=True))
    bench = bench_of(recording, declared, groups)
    names = {c.name: c for c in bench.candidates}
    (first, *_) = replays = bench.parts["fit"]

    def error(predictor, values):
        told = predictor.predict(values, replays)["speed_2"][0]
        return float(np.std(told - first.observed["speed_2"].values))

    plain = {p.name: p.value for p in bench.predictor.parameters}
    extended = bench.predictor.extended(names["presliding by clutch 2"])
    (own,) = names["presliding by clutch 2"].parameters
    # Drives go smoothly through their rows: less than a thousandth is left of what was missing.
    assert error(extended, {**plain, own.name: DISPLACEMENT}) < 1e-3 * error(bench.predictor, plain)


def test_how_far_a_clutch_slips_is_from_one_end_to_the_other():
    times = np.linspace(0.0, 2.0 * np.pi, 2001)
    speeds = np.column_stack([np.cos(times), 0.0 * times])
    poses = np.column_stack([np.sin(times), 0.0 * times])
    found = slip_travels(declared_joints(), times, poses, speeds)
    assert found == pytest.approx([2.0, 0.0], abs=1e-5)  # trapezoids of 3 ms
