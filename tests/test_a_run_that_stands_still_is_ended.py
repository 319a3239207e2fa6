"""A part too stiff for the solver ends the run with what there is, instead of running for ever."""

import pytest
from devices_for_tests import Block, Ramp, always_on
from effect_rig import attached, rig

from simpter_hybrid import compiled, engine
from simpter_hybrid.effects.command_scale import CommandScale
from simpter_hybrid.effects.play_hysteresis import PlayHysteresis
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.kernel.records import COUNTS
from simpter_hybrid.machine_code.program import Program, Room
from simpter_hybrid.running import segment
from simpter_hybrid.scenario import Scenario

ENGINES = pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])


@ENGINES
def test_a_damper_far_too_stiff(simulate, monkeypatch):
    # The same rule after fewer evaluations: only the waiting is shorter.
    monkeypatch.setattr(segment, "STALLED_AFTER", 12_000)
    # Pushed with 1 MN against 1 N of friction the block creeps on: nothing else ends the run.
    run = simulate(
        Scenario(
            "stiff", Block(), (always_on(1.0, 1.0),), (0.0,), (1e-5,), 1.0,
            loads=(Ramp(0.0, ((0.0, 1e6), (1.0, 1e6))),), command=(1.0,), excitation=(1.0,),
            effects=(ViscousDrag(coordinate=0, coefficient=1e12),),
        )
    )  # fmt: skip
    assert run.status == "failed"
    assert "stands still" in run.message
    ended = float(run.message.split("t = ")[1].split(" s")[0])
    # What was kept reaches to there, or to the step before.
    assert run.t_end == pytest.approx(ended, rel=1e-3)


@ENGINES
def test_guards_at_rounding_at_time_zero_do_not_hold_it_up(simulate):
    # Three plays start on their edges to within one rounding and are pushed over them at t = 0.
    run = simulate(rig([attached(PlayHysteresis), attached(CommandScale)], t_end=0.3))
    assert run.status == "finished", run.message


def test_a_caller_s_own_limit_of_steps_is_named():
    scenario = rig([attached(CommandScale)], t_end=0.3)
    found = Program(scenario).once(Room(64, 0, 0), step_limit=2)
    status, why = (int(v) for v in found.counts[0, :COUNTS])
    word, message = compiled.outcome(scenario, status, float(found.t[0]), why)
    assert word == "failed"
    assert f"at t = {float(found.t[0])!r} s more steps than its caller allows" in message
