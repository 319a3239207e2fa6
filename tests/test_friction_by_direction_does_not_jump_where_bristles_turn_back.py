"""Friction that differs between directions goes together with every model of presliding."""

import pytest
from effect_rig import rig

import simpter_hybrid as simpter
from simpter_hybrid.effects.asymmetry import Asymmetry
from simpter_hybrid.effects.bristles import Bristles
from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.effects.lugre import LuGre
from simpter_hybrid.effects.reset_integrator import ResetIntegrator

SHARE = -0.2


@pytest.mark.parametrize("model", [Bristles, Dahl, LuGre, ResetIntegrator])
def test_friction_by_direction_does_not_jump_where_bristles_turn_back(model):
    alone, directed = (
        simpter.run(rig([model(clutch=0), *more]))
        for more in ([], [Asymmetry(clutch=0, share=SHARE)])
    )
    # A torque that jumps where the slip turns holds it there, and no step is short enough.
    assert directed.status == "finished", directed.message
    assert len(directed.step_t) < 2 * len(alone.step_t)
