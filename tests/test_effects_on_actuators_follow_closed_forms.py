"""Every effect between command and torque against a step response that can be written down."""

from math import exp, log, sqrt

import numpy as np
import pytest
from devices_for_tests import Coulomb, RecordedCommands, TwoBlocks

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.controllers.replayed import ReplayedServo
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.coil_supply import CoilSupply
from simpter_hybrid.effects.command_scale import CommandScale
from simpter_hybrid.effects.command_slew import CommandSlew
from simpter_hybrid.effects.cross_coupling import CrossCoupling
from simpter_hybrid.effects.neighbour_command import NeighbourCommand
from simpter_hybrid.effects.other_commands import OtherCommands
from simpter_hybrid.effects.other_excitations import OtherExcitations
from simpter_hybrid.effects.play_hysteresis import PlayHysteresis
from simpter_hybrid.effects.pull_in import PullIn
from simpter_hybrid.effects.release_asymmetry import ReleaseAsymmetry
from simpter_hybrid.effects.remanence import Remanence
from simpter_hybrid.effects.second_lag import SecondLag
from simpter_hybrid.effects.slew_limit import SlewLimit
from simpter_hybrid.effects.stray_field import StrayField
from simpter_hybrid.effects.torque_lag import TorqueLag
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

#: Lag and off-to-on delay of the clutch, duration of a held command [s].
LAG, DELAY, HELD = 0.1, 0.02, 0.5
#: Solver tolerance 1e-10 a step, some tens of steps.
CLOSE = 1e-8


def steps(effects, commands, start=0.0):
    """A fast heavy rotor: the clutch slips, torque is 1 N m a volt; commands held in turn."""
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, delay=DELAY)
    run = Scenario("steps", Testbed(1e6), (clutch,), (0.0,), (5.0,), HELD * len(commands))
    return simulate(
        run.replace(
            effects=effects if isinstance(effects, tuple) else (effects,),
            controllers=((RecordedCommands(1.0), 1),),
            period=HELD,
            rec=(*commands, 0.0),
            command=(start,),
            excitation=(start,),
        )
    )


def excitation(run, t):
    return run.state(t, "left")[2]


def test_a_slew_limit_makes_a_ramp_and_then_the_lag_takes_over():
    run = steps(SlewLimit(clutch=0, slowness=1.0 / 20.0), (5.0,), start=1.0)
    # 20 V/s until (5 - u)/0.1 is less, at u = 3 V after 0.1 s.
    assert excitation(run, 0.05) == pytest.approx(2.0, rel=CLOSE)
    assert excitation(run, 0.25) == pytest.approx(5.0 - 2.0 * exp(-1.5), rel=1e-7)


def ramped(t, start, end, slope):
    """First-order lag behind a ramp from `start` to `end` [V] that begins at 0, of its start."""
    arrives = abs(end - start) / abs(slope)
    during = min(t, arrives)
    behind = start + slope * (during - LAG * (1.0 - exp(-during / LAG)))
    return end + (behind - end) * exp(-(t - during) / LAG)


def test_a_lag_behind_a_limited_supply_follows_its_ramp():
    run = steps(CommandSlew(clutch=0, slowness=1 / 20.0, slowness_down=1 / 40.0), (5.0, 1.0), 1.0)
    assert excitation(run, 0.1) == pytest.approx(ramped(0.1, 1.0, 5.0, 20.0), rel=CLOSE)
    first = ramped(HELD, 1.0, 5.0, 20.0)
    assert excitation(run, HELD) == pytest.approx(first, rel=CLOSE)
    # Where the lag begins a little below the ramp's start, that dies out by itself.
    assert excitation(run, HELD + 0.2) == pytest.approx(
        ramped(0.2, 5.0, 1.0, -40.0) + (first - 5.0) * exp(-0.2 / LAG), rel=CLOSE
    )


@pytest.mark.parametrize("order", [1, -1])
def test_a_limited_supply_goes_with_another_gain_before_and_after_it(order):
    both = (CommandScale(clutch=0, offset=0.2), CommandSlew(clutch=0, slowness=1.0 / 20.0))
    run = steps(both[::order], (5.0,), 1.0)
    # From 1 V the lag follows the ramp and, at once, the offset.
    level = ramped(0.3, 1.0, 5.0, 20.0) + 0.2 * (1.0 - exp(-0.3 / LAG))
    assert excitation(run, 0.3) == pytest.approx(level, rel=CLOSE)


def test_a_supply_limited_one_way_steps_the_other():
    run = steps(CommandSlew(clutch=0, slowness=1.0 / 20.0), (5.0, 1.0), 1.0)
    level = ramped(HELD, 1.0, 5.0, 20.0)
    assert excitation(run, HELD + 0.1) == pytest.approx(1.0 + (level - 1.0) * exp(-1), rel=CLOSE)


def test_a_lag_of_torque_moves_the_square_of_excitation_exponentially():
    linear = 0.3
    run = steps(TorqueLag(clutch=0, share=1.0, linear=linear), (5.0,), start=1.0)
    level = 5.0 * (5.0 + linear) - (25.0 + 5.0 * linear - 1.0 - linear) * exp(-0.2 / LAG)
    u = 0.5 * (sqrt(linear**2 + 4.0 * level) - linear)
    assert excitation(run, 0.2) == pytest.approx(u, rel=CLOSE)


def test_two_lags_in_a_row_have_the_textbook_step_response():
    lag = 0.04
    run = steps(SecondLag(clutch=0, lag=lag), (3.0,))
    t = 0.3 - DELAY
    level = 3.0 * (1.0 - (LAG * exp(-t / LAG) - lag * exp(-t / lag)) / (LAG - lag))
    assert -sample(run, [0.3]).tau[0, 0] == pytest.approx(level, rel=CLOSE)


def test_a_gap_closes_later_and_opens_sooner_by_what_is_said():
    run = steps(PullIn(clutch=0, extra=0.015, drop_out=0.45), (4.0, 0.0))
    on, off = (e.t for e in run.events if e.kind == "switched")
    assert on == pytest.approx(DELAY + 0.015, abs=1e-15)
    full = 4.0 * (1.0 - exp(-(HELD - on) / LAG))
    assert off - HELD == pytest.approx(LAG * log(full / 0.5), rel=CLOSE)


def test_release_takes_longer_by_its_share():
    run = steps(ReleaseAsymmetry(clutch=0, share=0.5), (4.0, 1.0), start=4.0)
    assert excitation(run, HELD + 0.3) == pytest.approx(
        1.0 + 3.0 * exp(-0.3 / (1.5 * LAG)), rel=CLOSE
    )


def test_a_scaled_command_is_where_the_excitation_goes():
    run = steps(CommandScale(clutch=0, gain=0.1, offset=-0.2), (3.0,), start=1.0)
    assert excitation(run, 0.4) == pytest.approx(3.1 - 2.1 * exp(-0.4 / LAG), rel=CLOSE)


def test_a_neighbours_excitation_shifts_the_command():
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, threshold=-1.0)
    run = Scenario("pair", TwoBlocks(1e6), (clutch, clutch), (0.0, 0.0), (5.0, 5.0), 3.0)
    held = {"command": (2.0, 4.0), "excitation": (2.0, 0.0)}
    end = simulate(
        run.replace(effects=(CrossCoupling(clutch=0, gain=-0.05, neighbour=1.0),), **held)
    )
    # u1' = (2 - 0.05 u2 - u1)/lag with u2 = 4 (1 - e^(-t/lag)): both lags are alike.
    x = 0.15 / LAG
    u = 2.0 - 0.05 * 4.0 * (1.0 - (1.0 + x) * exp(-x))
    assert end.state(0.15, "left")[4] == pytest.approx(u, rel=CLOSE)


def test_a_neighbours_field_adds_to_the_torque_and_not_to_the_own_excitation():
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, threshold=-1.0)
    run = Scenario("pair", TwoBlocks(1e6), (clutch, clutch), (0.0, 0.0), (5.0, 5.0), 1.0)
    run = run.replace(command=(2.0, 4.0), excitation=(2.0, 0.0))
    end = simulate(run.replace(effects=(StrayField(clutch=0, gain=0.1, neighbour=1.0),)))
    seen = sample(end, np.array([0.1, 0.9]))
    assert seen.excitation[:, 0] == pytest.approx([2.0, 2.0], rel=CLOSE)
    field = 4.0 * (1.0 - np.exp(-np.array([0.1, 0.9]) / LAG))
    assert seen.tau_slip[:, 0] == pytest.approx(2.0 + 0.1 * field, rel=CLOSE)


def test_the_others_commands_shift_the_command():
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, threshold=-1.0)
    run = Scenario("pair", TwoBlocks(1e6), (clutch, clutch), (0.0, 0.0), (5.0, 5.0), 1.0)
    run = run.replace(command=(2.0, 4.0), excitation=(1.0, 0.0))
    end = simulate(run.replace(effects=(OtherCommands(clutch=0, gain=-0.05),)))
    assert end.state(0.2, "left")[4] == pytest.approx(1.8 - 0.8 * exp(-0.2 / LAG), rel=CLOSE)
    assert end.state(0.2, "left")[5] == pytest.approx(4.0 - 4.0 * exp(-0.2 / LAG), rel=CLOSE)
    # A supply that sags by a hundredth a volt of the other's command: 2 (1 - 0.04).
    end = simulate(run.replace(effects=(OtherCommands(clutch=0, relative=-0.01),)))
    assert end.state(0.2, "left")[4] == pytest.approx(1.92 - 0.92 * exp(-0.2 / LAG), rel=CLOSE)
    # What an earlier effect makes of the own command is none of the others': 2 + 0.4 - 0.2.
    both = (CommandScale(clutch=0, gain=0.2), OtherCommands(clutch=0, gain=-0.05))
    for order in (both, both[::-1]):
        end = simulate(run.replace(effects=order)).state(0.2, "left")[4]
        right = 2.2 if order == both else 1.2 * 1.8
        assert end == pytest.approx(right + (1.0 - right) * exp(-0.2 / LAG), rel=CLOSE)


def test_the_others_excitations_shift_the_command():
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, threshold=-1.0)
    run = Scenario("pair", TwoBlocks(1e6), (clutch, clutch), (0.0, 0.0), (5.0, 5.0), 1.0)
    run = run.replace(command=(2.0, 4.0), excitation=(2.0, 0.0))
    x = 0.15 / LAG
    for sag in ({"gain": -0.05}, {"relative": -0.025}):  # of 2 V both are -0.05 u2
        end = simulate(run.replace(effects=(OtherExcitations(clutch=0, **sag),)))
        # u1' = (2 - 0.05 u2 - u1)/lag with u2 = 4 (1 - e^(-t/lag)): both lags are alike.
        u = 2.0 - 0.05 * 4.0 * (1.0 - (1.0 + x) * exp(-x))
        assert end.state(0.15, "left")[4] == pytest.approx(u, rel=CLOSE)


def test_a_recorded_neighbours_command_arrives_through_its_own_coil():
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=LAG, delay=DELAY)
    run = Scenario("steps", Testbed(1e6), (clutch,), (0.0,), (5.0,), HELD)
    recorded = ReplayedServo(0.0, 0.0, 0.0)
    rec = (1.0, 1.0, 1.0, 2.0, 4.0, 0.0)  # torque mode, one row for good
    effect = NeighbourCommand(clutch=0, gain=0.05, lag=0.3)
    run = run.replace(controllers=((recorded, 1),), period=HELD, rec=rec, effects=(effect,))
    found = simulate(run.replace(command=(2.0,), excitation=(2.0,)))
    # u' = (2 + 0.05 v - u)/lag, v = 4 (1 - e^(-t/0.3)): two lags in a row.
    t = 0.4
    slow, fast = exp(-t / 0.3), exp(-t / LAG)
    expected = 2.0 + 0.2 * (1.0 - (0.3 * slow - LAG * fast) / (0.3 - LAG))
    assert excitation(found, t) == pytest.approx(expected, rel=CLOSE)


def test_a_supply_at_its_limit_charges_the_coil_by_its_own_constant():
    coil = CoilSupply(clutch=0, inductive=0.12, clamp=6.0, stiffness=20.0)
    run = steps(coil, (5.0,), start=1.0)
    # Saturated while 5 + 20 (5 - u) > 6, up to u = 4.95 V, at 0.12 ln(5/1.05) = 0.187 s.
    assert excitation(run, 0.15) == pytest.approx(6.0 - 5.0 * exp(-0.15 / 0.12), rel=CLOSE)


def test_remanence_keeps_torque_up_until_the_play_is_taken_up():
    run = steps(Remanence(clutch=0, width=0.3), (4.0, 1.0, 3.0))
    seen = sample(run, [0.45, HELD + 0.01, HELD + 0.2, 2 * HELD + 0.01, 2 * HELD + 0.3])
    u, torque = seen.excitation[:, 0], -seen.tau[:, 0]
    top = excitation(run, HELD)
    bottom = excitation(run, 2 * HELD)
    expected = [u[0] - 0.3, top - 0.3, u[2] + 0.3, bottom + 0.3, u[4] - 0.3]
    assert torque == pytest.approx(expected, rel=CLOSE)
    # The second and the fourth instant are within the play: excitation has moved, torque has not.
    assert u[1] < top - 0.1
    assert u[3] > bottom + 0.1


def test_plays_side_by_side_equal_plays_stepped_through_the_excitation():
    run = steps(PlayHysteresis(clutch=0, share=0.6, width=0.9), (4.0, 1.0, 3.0, 2.5, 3.5, 0.5))
    times = np.arange(3001) / 1000.0
    seen = sample(run, times)
    u = seen.excitation[:, 0]
    widths, memory, expected = np.array([0.3, 0.6, 0.9]), np.zeros(3), []
    for value in u:
        memory = np.minimum(np.maximum(memory, value - widths), value + widths)
        expected.append(max(0.0, 0.4 * value + 0.6 * memory.mean()))
    on = times > DELAY
    # Turning points lie on the grid, so the only error is the solver's.
    assert -seen.tau[on, 0] == pytest.approx(np.array(expected)[on], abs=1e-7)
