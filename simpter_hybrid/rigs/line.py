"""The line-following run of chapter 5, with any torque selector and clutch controller."""

from __future__ import annotations

import math

from ..clutch import Clutch
from ..controller import Controller
from ..controllers.blending import Blending
from ..controllers.gomes_translator import GomesImpedanceToLine
from ..controllers.gomes_velocity import GomesVelocityController
from ..controllers.impedance import ImpedanceToLine
from ..controllers.inverse_model import InverseModel
from ..controllers.lookup import LookupTable
from ..controllers.torque_feedback import TorqueFeedback
from ..controllers.velocity import VelocityController
from ..devices.pter import Pter
from ..devices.pter_equations import inverse_kinematics
from ..known_units import INCH
from ..laws import LBF_IN, TestbedTorque
from ..loads.operator import Operator
from ..scenario import Scenario
from ..stop import Singular, TipPassesX
from .inputs import Inputs, nominal

#: A clutch stays engaged as long as any current is left: the thesis's "zero input current" rule
#: with a lag that never quite gets there [V].
STILL_ON = 1e-6


def selector(kind: str, inputs: Inputs) -> Controller:
    """A torque selector by name: impedance, gomes-translator, velocity, gomes-velocity.

    Parameters
    ----------
    kind : str
    inputs : Inputs
        Of the path, the spring and the steering.

    Raises
    ------
    ValueError
        If there is no selector of that name.
    """
    line = {"x": 0.0, "y": inputs.line_y, "angle": 0.0}
    spring = {"stiffness": inputs.stiffness, "damping": inputs.damping}
    steer = {"gain": inputs.steering_gain, "lock_torque": inputs.table_torque}
    if kind == "impedance":
        return ImpedanceToLine(**spring, **line)
    if kind == "gomes-translator":
        return GomesImpedanceToLine(**spring, **line)
    if kind == "velocity":
        return VelocityController(inputs.heading_distance, **steer, **line)
    if kind == "gomes-velocity":
        return GomesVelocityController(**steer, **line)
    raise ValueError(
        f"torque selector {kind!r} is unknown; it has to be impedance, gomes-translator, velocity "
        "or gomes-velocity"
    )


def line(
    kind: str = "impedance",
    gain: float = 0.0,
    inputs: Inputs | None = None,
    *,
    fade: float | None = None,
    matched: bool = False,
    law: TestbedTorque | None = None,
    name: str = "line-y24",
) -> Scenario:
    """The standard run: path y = 24 in, from (3, 24) in to x = -28 in.

    Parameters
    ----------
    kind : str
        Torque selector, see ``selector``.
    gain : float
        Of the torque feedback [V/(lb-in)]; 0 leaves the look-up table alone.
    inputs : Inputs, optional
        Nominal ones when left out.
    fade : float, optional
        Time within which clutches are applied and released [s].
    matched : bool
        Whether the clutch controller inverts the clutch's own torque map instead of the table.
    law : TestbedTorque, optional
        Torque map of the four clutches; (39) and (43) when left out.
    name : str
    """
    x = nominal() if inputs is None else inputs
    device = Pter(x.alpha, x.beta, x.gamma, x.l_a, x.l_d)
    q = [0.0, 0.0]
    inverse_kinematics(3 * INCH, x.line_y, 1, [0.0, 0.0, 0.0, x.l_a, x.l_d], q)
    clutch = Clutch(
        law or TestbedTorque(), time_constant=x.time_constant, delay=x.delay, threshold=STILL_ON
    )
    stages: list[Controller] = [selector(kind, x)]
    if fade is not None:
        stages.append(Blending(fade, fade))
    stages.append(InverseModel() if matched else LookupTable(x.table_torque))
    if gain != 0.0:
        stages.append(TorqueFeedback(gain / LBF_IN))
    # The push points along -x; +90 degrees from there is -y, and the sinusoids are meant along +y.
    share = -x.normal / len(x.frequencies)
    lines = tuple((share, f, phase) for f, phase in zip(x.frequencies, x.phases, strict=True))
    return Scenario(
        name,
        device,
        (clutch,) * 4,
        tuple(q),
        (0.0, 0.0),
        12.0,
        loads=(Operator(x.push, math.pi, lines),),
        controllers=tuple((stage, 1) for stage in stages),
        stops=(TipPassesX(x.stop_x, 1.0), Singular()),
        period=1.0 / x.rate,
    )
