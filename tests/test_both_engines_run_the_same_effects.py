"""The compiled engine compiles the effects' own text: the same events, the same end."""

import numpy as np
import pytest
from devices_for_tests import always_on
from effect_rig import BETWEEN, all_effects, attached, pair, rig

from simpter_hybrid import engine
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.effects.thermal_fade import ThermalFade
from simpter_hybrid.scenario import Scenario

pytest.importorskip("llvmlite", reason="the compiled engine needs llvmlite")


CASES = {cls.__name__: rig([attached(cls)]) for cls in all_effects()}
CASES |= {f"{name}, two clutches": pair([effect]) for name, effect in BETWEEN.items()}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_an_effect_does_the_same_in_both_engines(case):
    from simpter_hybrid import compiled

    scenario = CASES[case]
    one, other = engine.simulate(scenario), compiled.simulate(scenario)
    assert (one.status, other.status) == ("finished", "finished"), other.message
    first, second = ([(e.kind, e.before, e.after) for e in run.events] for run in (one, other))
    assert first == second
    # Two step-size controls at 1e-10; the events amplify by some hundred.
    n = 2 * scenario.device.n + scenario.device.m
    np.testing.assert_allclose(one.end[:n], other.end[:n], rtol=0.0, atol=1e-7)


@pytest.mark.parametrize("effects", [(), (ThermalFade(clutch=0),)])
def test_the_start_is_the_same_event_in_both_engines(effects):
    from simpter_hybrid import compiled

    # With an effect that is fed the torque, sampling settles the clutch before it is switched.
    scenario = Scenario(
        "axis", LinearAxis(mass=1.0), (always_on(1.0, 1.0),), (0.0,), (0.0,), 0.1,
        command=(1.0,), excitation=(1.0,), effects=effects,
    )  # fmt: skip
    for simulate in (engine.simulate, compiled.simulate):
        told = [(e.kind, e.before, e.after) for e in simulate(scenario).events]
        assert told == [("start", (3,), (0,))]
