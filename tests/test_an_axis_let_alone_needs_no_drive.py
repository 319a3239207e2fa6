"""A rotor is spun up and let alone, an angle or a speed is logged: coast-down, in closed form."""

from dataclasses import replace

import numpy as np
import pytest
from coasting_rotor import MAP, MODEL, NOISE, POSITION, coasting, declared, logged

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.bench import axis_bench
from simpter_hybrid.identification.axis.recorded import as_axis, placeless
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fits import check_fits
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.problems import InvalidInput

TORQUE = '[channels.torque]\ncolumn = "torque"\nunit = "N*m"\nsign = 1\nrole = "input"\n'


def test_a_model_without_motor_and_controller_predicts_the_coast(tmp_path):
    replay = axis_replays(as_axis(logged(tmp_path)), AxisSignals())[0]
    predictor = ScenarioPredictor(declared(), AxisRig(alone=True))
    told = predictor.predict({"Coulomb friction": 1.0}, [replay])["speed"][0]
    # Windows start at parabolas through five samples or so of noise 0.02 rad/s.
    assert told == pytest.approx(coasting(replay.time, 40.0), abs=4 * NOISE)


def test_nothing_is_missing_and_no_place_is_asked_for(tmp_path):
    found = diagnose(logged(tmp_path), declared())
    assert found.search.verdict.kind == "nothing missing"
    assert not {"spring-force", "imbalance", "drive-lag"} & {c.name for c in found.candidates}


def test_of_a_speed_alone_a_constant_force_is_tried_but_shows_in_no_place(tmp_path):
    recording = as_axis(logged(tmp_path))
    tried = axis_bench(recording, declared(), groups_of(recording)).candidates
    (bias,) = (c for c in tried if c.name == "bias-force")
    assert set(bias.coordinates) == {"force:direction", "force:time", "force:slip_velocity"}
    assert not any(place.endswith(":position") for c in tried for place in c.coordinates)


def test_what_says_nothing_is_played_no_more_often_than_there_are_rows(tmp_path):
    recording = as_axis(logged(tmp_path))
    bench = axis_bench(recording, declared(), groups_of(recording))
    run = recording.runs[0].time
    _, _, count, *rest = bench.predictor.rig.pack(bench.parts["fit"][0], run[1] - run[0])
    assert bench.predictor.rig.played == pytest.approx(run[1] - run[0])
    assert count <= run.size
    assert not any(rest[2::3])


def test_a_model_that_depends_on_the_place_needs_it(tmp_path):
    replay = axis_replays(as_axis(logged(tmp_path)), AxisSignals())[0]
    predictor = ScenarioPredictor(parse(MODEL), AxisRig(alone=True))
    with pytest.raises(InvalidInput, match="a channel called position"):
        placeless(predictor, replay, ())


@pytest.mark.parametrize(
    ("map_text", "said"),
    [
        (MAP.replace("driven = false\n", "") + POSITION, "driven = false"),
        (MAP + POSITION + TORQUE, "driven and not driven"),
        (MAP.replace("driven = false\n", "") + POSITION + TORQUE, "driven = false in the map"),
    ],
)
def test_what_drives_is_logged_or_said_to_be_nothing(tmp_path, map_text, said):
    with pytest.raises(InvalidInput, match=said):
        diagnose(logged(tmp_path, map_text), declared())


@pytest.mark.parametrize(
    ("step", "taken"), [(1.0, True), (10.0, False), (3e-4, True), (3e-5, False)]
)
def test_a_row_a_second_or_a_tenth_of_one_will_do_and_a_wrong_unit_of_time_will_not(
    tmp_path, step, taken
):
    recording = as_axis(logged(tmp_path))
    slow = replace(recording.runs[0], time=step * np.arange(recording.runs[0].time.size))
    recording = replace(recording, runs=tuple(slow for _ in recording.runs))
    if taken:
        return check_fits(recording, declared())
    with pytest.raises(InvalidInput, match="is the unit of time in the map right"):
        check_fits(recording, declared())
    return None
