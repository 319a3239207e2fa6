"""Gomes's tests on the assembled robot: a hand at the tip, one clutch (thesis 4.2)."""

from __future__ import annotations

import math

from ..clutch import Clutch
from ..controllers.hand import HandAtTip
from ..controllers.profile import CommandProfile
from ..devices.pter import Pter
from ..effects.coil_supply import CoilSupply
from ..laws import TestbedTorque
from ..loads.hand import HeldTipForce
from ..loads.piecewise import PiecewiseTipForce
from ..scenario import Scenario
from .inputs import Inputs, nominal

#: Link angles at the start: link A sweeps towards and past the direction of link B.
START = (0.2, 1.1)
#: Speed that the hand wants of link A [rad/s].
SPEED = 0.2


def robot(inputs: Inputs) -> Pter:
    """The device of the inputs.

    Parameters
    ----------
    inputs : Inputs
    """
    return Pter(inputs.alpha, inputs.beta, inputs.gamma, inputs.l_a, inputs.l_d)


def moving(
    points: tuple[tuple[float, float], ...],
    crossover: float,
    t_end: float,
) -> Scenario:
    """A hand turns link A at constant speed while clutch 1's coil is commanded a voltage.

    Parameters
    ----------
    points : tuple of (float, float)
        Course of clutch 1's command [s, V].
    crossover : float
        How quickly the hand corrects its speed [rad/s]: its gain is this times the link's inertia.
    t_end : float
        Duration [s].
    """
    x = nominal()
    clutch = Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay)
    gain = crossover * 2.0 * x.alpha
    hand = HandAtTip(SPEED, gain, 0.25 * crossover * gain)
    return Scenario(
        "in-place",
        robot(x),
        (clutch,) * 4,
        START,
        (SPEED, 0.0),
        t_end,
        loads=(HeldTipForce(),),
        controllers=((hand, 1), (CommandProfile(points), 1)),
        # No current control: a coil's 0.124 s, in place of the lag of chapter 5.
        effects=(CoilSupply(stiffness=0.0, clutch=0),),
        period=0.01,
    )


def sine_points(
    bias: float, amplitude: float, frequency: float, t_end: float
) -> tuple[tuple[float, float], ...]:
    """A biased sinusoid as a course of commands, a point every 10 ms [s, V].

    Parameters
    ----------
    bias, amplitude : float
        [V].
    frequency : float
        [Hz].
    t_end : float
        [s].
    """
    return tuple(
        (0.01 * k, bias + amplitude * math.sin(2.0 * math.pi * frequency * 0.01 * k))
        for k in range(int(t_end / 0.01) + 1)
    )


def breakaway(volts: float, angle: float, slope: float) -> Scenario:
    """Clutch 1 at constant excitation, a tip force ramped up in one direction until it slips.

    Parameters
    ----------
    volts : float
        [V].
    angle : float
        Direction of the force from the x axis [rad].
    slope : float
        [N/s].
    """
    x = nominal()
    clutch = Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay)
    end = 10.0
    far = (end, slope * end * math.cos(angle), slope * end * math.sin(angle))
    return Scenario(
        "in-place-breakaway",
        robot(x),
        (clutch,) * 4,
        START,
        (0.0, 0.0),
        end,
        loads=(PiecewiseTipForce(((0.0, 0.0, 0.0), far)),),
        command=(volts, 0.0, 0.0, 0.0),
        excitation=(volts, 0.0, 0.0, 0.0),
    )
