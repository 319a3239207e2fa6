"""Heat, wear and time do not begin anew in the pieces of one run."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.by_temperature import FrictionByTemperature
from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.effects.wear_in import WearIn
from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.sizes import sizes_of
from simpter_hybrid.identification.axis.traces import AxisTracer
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.simulated_runs import simulated_runs

LACKS = {
    "drift": Drift(clutch=0, rate_per_time=0.3),
    "wear": WearIn(clutch=0, change=1.5, scale=5.0),
}


def _first_take(folder, effect, pieces=3):
    """Pieces of one take of a recording of an axis with that effect, and a model that has it."""
    recorded_axis(folder, [effect], rate_noise=1e-3)
    described = (folder / "map.toml").read_text(encoding="utf-8")
    cut = described.replace("[runs]", f"[runs]\npieces = {pieces}")
    (folder / "map.toml").write_text(cut, encoding="utf-8")
    recording = load_recording(folder / "data.csv", folder / "map.toml")
    predictor = ScenarioPredictor(replace(declared_axis(), effects=(effect,)), AxisRig())
    return predictor, axis_replays(recording, AxisSignals())[:pieces]


def _off(predictor, replays):
    """Root mean square of the error of each run's speed [rad/s]."""
    told = predictor.predict({p.name: p.value for p in predictor.parameters}, replays)["speed"]
    seen = [r.observed["speed"].values for r in replays]
    return [float(np.std(a - b)) for a, b in zip(seen, told, strict=True)]


@pytest.mark.parametrize("name", sorted(LACKS))
def test_the_last_piece_is_predicted_as_well_as_the_first(tmp_path, name):
    predictor, pieces = _first_take(tmp_path, LACKS[name])
    first, *_, last = _off(predictor, pieces)
    (anew,) = _off(predictor, [replace(pieces[-1], before=None)])
    assert last < 1.2 * first  # noise, and starts of windows that are estimated
    assert anew > 3.0 * last


def test_so_is_the_second_half(tmp_path):
    predictor, (whole,) = _first_take(tmp_path, LACKS["drift"], pieces=1)
    both = halves(whole)
    first, second = _off(predictor, both)
    assert second < 1.2 * first
    assert _off(predictor, [replace(both[1], before=None)])[0] > 3.0 * second


def test_ranges_of_what_changes_in_time_are_of_the_whole_run(tmp_path):
    _, pieces = _first_take(tmp_path, LACKS["drift"])
    lasts = sizes_of(pieces, 1.0, 0.02, turning=True).duration
    assert lasts == pytest.approx(4.0, abs=0.01)  # and not a third of it


def test_what_follows_a_channel_is_given_the_course_of_each_piece():
    warms = FrictionByTemperature(clutch=0, change=0.01)
    model = replace(declared_axis(), effects=(warms,))
    assert not ScenarioPredictor(model, AxisRig()).remembers


def test_pieces_are_simulated_once_together(tmp_path):
    predictor, pieces = _first_take(tmp_path, LACKS["wear"])
    together = simulated_runs(pieces, remembers=True)
    assert [[i for i, _ in made.parts] for made in together] == [[0, 1, 2]]
    alone = [_off(predictor, [piece])[0] for piece in pieces]
    assert _off(predictor, pieces) == pytest.approx(alone, rel=1e-4)  # steps end elsewhere


def test_pieces_with_numbers_of_their_own_are_not(tmp_path):
    _, pieces = _first_take(tmp_path, LACKS["wear"])
    own = [replace(piece, own={"Coulomb friction": 1.1}) for piece in pieces]
    assert len(simulated_runs(own, remembers=True)) == 3


def test_a_model_without_memory_begins_with_each_piece(tmp_path):
    _, pieces = _first_take(tmp_path, LACKS["drift"])
    falls = Stribeck(clutch=0, rise=0.3)
    predictor = ScenarioPredictor(replace(declared_axis(), effects=(falls,)), AxisRig())
    assert not predictor.remembers
    made = simulated_runs(pieces, predictor.remembers)
    assert all(one.run is piece for one, piece in zip(made, pieces, strict=True))


def test_what_is_left_is_asked_along_the_time_of_the_whole_run(tmp_path):
    predictor, pieces = _first_take(tmp_path, LACKS["drift"])
    values = {p.name: p.value for p in predictor.parameters}
    traces = AxisTracer(0.02)(predictor, values, pieces)["force"]
    for name in ("time", "distance"):
        ends = [(t.coordinates[name][0], t.coordinates[name][-1]) for t in traces]
        assert [b for b, _ in ends[1:]] == pytest.approx([e for _, e in ends[:-1]], rel=0.05)
