"""An effect on a drive has its motor's numbers, also where a fit has moved these."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.effects.drive_deadband import DriveDeadband
from simpter_hybrid.identification import diagnosis
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.fitting.fitted_model import Model
from simpter_hybrid.identification.rigs.corrected import as_written
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.loads.drive import VoltageDrive

#: Force for each volt, and what speed takes of it: 0.05 and 0.005.
MOTOR = VoltageDrive(constant=0.1, resistance=2.0)
KNOWN = {"name": "motor constant", "parameters": ["load.1.constant"], "relative": 0.2}


def predictor(name, tolerance=KNOWN, **changes):
    """Predictor of a motor by voltage with one candidate, and the names of its free numbers."""
    declared = replace(
        declared_axis(), loads=(MOTOR,), notes={"tolerances": [tolerance]}, **changes
    )
    tried = {c.name: c for c in drive_candidates(declared, sensed=False, told=12.0)}
    return ScenarioPredictor(declared, AxisRig()).extended(tried[name])


def numbers(model, values, effect):
    """The effect's numbers as simulated and as written, of which each pair has to be the same."""
    p = model.vector(values)[0]
    written = model.scenario(values).effects[-1]
    of = f"effect.{len(model.scenario(values).effects)}.{effect}."
    found = {}
    for field in type(written).of_motor:
        found[field] = p[model.runner.names[of + field]]
        assert getattr(written, field) == pytest.approx(found[field], rel=1e-12)
    return found


@pytest.mark.parametrize("factor", [1.0, 0.5])
def test_constants_follow_the_motor_constant(factor):
    band = predictor("drive-deadband")
    values = {"motor constant": factor, "drive-deadband.width": 9.0}
    assert numbers(band, values, "DriveDeadband") == {"constant": pytest.approx(0.05 * factor)}
    heat = predictor("winding-heat")
    values = {"motor constant": factor, "winding-heat.rise": 0.1, "winding-heat.cooling": 60.0}
    back = pytest.approx(0.005 * factor**2)
    assert numbers(heat, values, "WindingHeat")["back"] == back


def test_an_effect_that_is_declared_follows_unless_it_has_a_tolerance_itself():
    band = DriveDeadband(coordinate=0, width=1.0, constant=0.04)
    model = predictor("drive-gain", effects=(band,))
    values = {"motor constant": 0.5, "drive-gain.gain": 0.0}
    assert model.scenario(values).effects[0].constant == pytest.approx(0.02)
    both = ["load.1.constant", "effect.1.DriveDeadband.constant"]
    model = predictor("drive-gain", {**KNOWN, "parameters": both}, effects=(band,))
    assert model.scenario(values).effects[0].constant == pytest.approx(0.02)


def test_a_dead_band_takes_no_more_than_a_limit_beside_it_leaves():
    limit = predictor("supply-limit")
    tried = {c.name: c for c in drive_candidates(limit.declared, sensed=False, told=12.0)}
    model = limit.extended(tried["drive-deadband"])
    values = {"motor constant": 1.0, "supply-limit.limit": 4.0, "drive-deadband.width": 9.0}
    assert model.scenario(values).effects[1].width == 4.0
    names = model.runner.names
    assert model.vector(values)[0][names["effect.2.DriveDeadband.width"]] == 4.0
    fitted = Model(model, values, 1.0, {}, 1.0, np.zeros(0))
    assert as_written(fitted).values == {**values, "drive-deadband.width": 4.0}
    narrow = replace(fitted, values={**values, "drive-deadband.width": 3.0})
    assert as_written(narrow) is narrow


def test_a_dead_band_may_take_all_that_was_told():
    declared = predictor("drive-gain").declared
    tried = {c.name: c for c in drive_candidates(declared, sensed=False, force=0.1, told=11.0)}
    (width,) = tried["drive-deadband"].parameters
    assert width.upper == 11.0  # twice the friction would be 2 V


def test_a_diagnosis_tells_the_numbers_as_they_are_written(tmp_path, monkeypatch):
    def written(model):
        return replace(model, values={**model.values, "width": 4.0})

    monkeypatch.setattr(diagnosis, "as_written", written)
    found = diagnosis.diagnose(recorded_axis(tmp_path, []), declared_axis(), candidates=())
    assert found.search.corrected.values["width"] == 4.0
