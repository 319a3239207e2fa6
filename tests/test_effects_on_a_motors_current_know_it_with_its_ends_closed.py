"""A driver that opens its motor's ends lets no current be cut or warm: such a pair made energy."""

from dataclasses import replace

import pytest
from axis_recordings import declared_axis

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.effects.drive_limit import DriveLimit
from simpter_hybrid.effects.drive_released import DriveReleased
from simpter_hybrid.effects.winding_heat import WindingHeat
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.loads.drive import VoltageDrive
from simpter_hybrid.problems import InvalidInput

MOTOR = VoltageDrive(constant=0.1, resistance=1.0, supply=12.0)
EFFECTS = WindingHeat(coordinate=0, rise=0.5), DriveLimit(coordinate=0, limit=2.0)
#: Candidates that are such effects.
OF_CURRENT = {"winding-heat", "drive-limit", "supply-limit"}


def declared(coasting, *effects):
    return replace(
        declared_axis(), loads=(replace(MOTOR, coasting=coasting),), effects=tuple(effects)
    )


@pytest.mark.parametrize("effect", EFFECTS)
def test_effects_on_a_current_are_refused_where_a_driver_opens_its_motor(effect):
    validate(declared(0.0, effect))
    with pytest.raises(InvalidInput, match="takes the ends of its motor for closed"):
        validate(declared(1.0, effect))


@pytest.mark.parametrize("effect", EFFECTS)
def test_they_are_refused_beside_a_driver_that_opens_them_where_it_is_told_nothing(effect):
    opens = DriveReleased(coordinate=0, share=1.0)
    validate(declared(0.0, opens))
    with pytest.raises(InvalidInput, match="opens the ends of a motor that another effect takes"):
        validate(declared(0.0, effect, opens))
    with pytest.raises(InvalidInput, match="takes the ends of its motor for closed"):
        validate(declared(1.0, opens))


@pytest.mark.parametrize("coasting", [0.0, 1.0])
def test_effects_on_a_current_are_not_tried_there(coasting):
    scenario = declared(coasting)
    predictor = ScenarioPredictor(scenario, AxisRig())
    known = {c.name: c for c in drive_candidates(scenario, sensed=False)}
    tried = {name for name, c in known.items() if predictor.combines(c)}
    assert OF_CURRENT & tried == (OF_CURRENT if coasting == 0.0 else set())
    # Nor beside a driver that was found to open them.
    opened = predictor.extended(known["drive-coasting"])
    assert not any(opened.combines(known[name]) for name in OF_CURRENT)
    # Nor may it be found to open them where the model has such an effect.
    warm = ScenarioPredictor(declared(0.0, EFFECTS[0]), AxisRig())
    assert not warm.combines(known["drive-coasting"])
