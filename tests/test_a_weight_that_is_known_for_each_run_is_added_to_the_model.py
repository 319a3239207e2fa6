"""``adds_to`` of a constant: what was hung on is no lack, and no friction of another day."""

from dataclasses import replace

import pytest
from axis_recordings import MAP, declared_axis, recorded_axis, written

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.fits import check_fits
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.problems import InvalidInput

#: Of each take, over the declared inertia of 0.02 kg m^2.
INERTIA = (1.0, 1.5, 2.0)
HUNG = """
[channels.hung]
column = "gcm2"
unit = "g*cm^2"
sign = 1
role = "constant"
"""
ADDED = HUNG + 'adds_to = "device.inertia"\n'


@pytest.fixture(scope="module")
def rows(tmp_path_factory):
    folder = tmp_path_factory.mktemp("made")
    recorded_axis(folder, [], inertia=INERTIA)
    head, *lines = (folder / "data.csv").read_text(encoding="utf-8").splitlines()
    hung = [(times - 1.0) * 0.02 * 1e7 for times in INERTIA]
    return [f"{head},gcm2", *(f"{line},{hung[int(line[0])]:g}" for line in lines)]


def _left(folder, rows, described, values=None):
    """Error of the declared model on each part, in deviations."""
    recording = as_recorded(written(folder, rows, described))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    nominal = {p.name: p.value for p in bench.predictor.parameters} | (values or {})
    return [
        rms(weighted_residuals(bench.predictor, nominal, runs)) for runs in bench.parts.values()
    ]


def test_each_run_is_predicted_with_its_own(tmp_path, rows):
    known = _left(tmp_path, rows, MAP + ADDED)
    # As well as the first, which has nothing hung on; 1000 rows tell an error to 2 %.
    assert max(known[1:]) < 1.05 * known[0]
    unknown = _left(tmp_path, rows, MAP + HUNG)
    assert unknown[0] == pytest.approx(known[0])  # nothing hung on in the first
    assert min(unknown[1:]) > 5.0 * max(known)


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("device.inertia", "device.inertial", "did you mean device.inertia"),
        ("device.inertia", "load.1.coordinate", "no parameter of the model"),
        ('"g*cm^2"', '"g"', "of device.inertia"),
    ],
)
def test_what_the_model_does_not_have_is_refused(tmp_path, rows, old, new, told):
    recording = written(tmp_path, rows, MAP + ADDED.replace(old, new))
    with pytest.raises(InvalidInput, match=told):
        check_fits(as_recorded(recording), declared_axis())


def test_all_that_is_wrong_with_it_is_told_at_once(tmp_path, rows):
    again = ADDED.replace("channels.hung", "channels.again")
    moving = ADDED.replace("hung", "moving").replace("gcm2", "torque").replace('"g*cm^2"', '"kg"')
    driven = (
        ADDED.replace("hung", "driven").replace("gcm2", "rate").replace('"constant"', '"input"')
    )
    recording = written(tmp_path, rows, MAP + ADDED + again + moving + driven)
    with pytest.raises(InvalidInput) as told:
        check_fits(as_recorded(recording), declared_axis())
    said = [str(problem) for problem in told.value.problems]
    assert any("channels.hung adds it already" in text for text in said)
    assert any("another value in one row" in text and "torque of take 0" in text for text in said)
    assert any("channels.moving.unit" in text and "of device.inertia" in text for text in said)
    assert any("not a constant of runs" in text and "channels.driven" in text for text in said)


def test_a_tolerance_is_one_of_all_of_it_also_of_a_runs_own_value(tmp_path, rows):
    recording = as_recorded(written(tmp_path, rows, MAP + ADDED))
    held = [{"name": "inertia", "parameters": ["device.inertia"], "relative": 0.2}]
    declared = replace(declared_axis(), notes={"tolerances": held})
    bench = bench_of(recording, declared, groups_of(recording))
    (run,) = bench.parts["report"]  # 0.04 in all
    other = with_parameters(declared, {"device.inertia": 1.2 * 0.04})
    alone = replace(bench.predictor, declared=other)
    whole = alone.predict({"inertia": 1.0}, [replace(run, added={})])["position"][0]
    for values, own in (({"inertia": 1.2}, {}), ({"inertia": 1.0}, {"inertia": 1.2})):
        found = bench.predictor.predict(values, [replace(run, own=own)])["position"][0]
        assert found == pytest.approx(whole, abs=1e-9)
