"""One clutch regulated to a torque while a larger one drives it (thesis 5.4.3, Figure 50)."""

from __future__ import annotations

from ..clutch import Clutch
from ..controllers.desired_torque import DesiredTorque
from ..controllers.lookup import LookupTable
from ..controllers.torque_feedback import TorqueFeedback
from ..devices.testbed import Testbed
from ..laws import LBF_IN, TestbedTorque
from ..loads.ramp import RampOnCoordinate
from ..scenario import Scenario
from .inputs import Inputs, nominal


def regulation(
    gain: float,
    rate: float = 30.0,
    *,
    torque: float = 250 * LBF_IN,
    wanted: float = 150 * LBF_IN,
    inputs: Inputs | None = None,
    t_end: float = 0.5,
    name: str = "regulation",
) -> Scenario:
    """A constant torque on one clutch, whose controller is to hold another.

    Link A alone stands for the device (inertia 2 alpha): the clutch in question links it to ground,
    the others are off. The thesis does not print the inertia; the slip speed it decides enters (39)
    by 15 % per rad/s only.

    Parameters
    ----------
    gain : float
        Of the torque feedback [V/(lb-in)].
    rate : float
        Of the controller [Hz].
    torque, wanted : float
        Input and desired torque [N m].
    inputs : Inputs, optional
    t_end : float
        Duration [s].
    name : str
    """
    x = nominal() if inputs is None else inputs
    stages = (
        DesiredTorque(wanted),
        LookupTable(x.table_torque),
        TorqueFeedback(gain / LBF_IN),
    )
    return Scenario(
        name,
        Testbed(2.0 * x.alpha),
        (Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay),),
        (0.0,),
        (0.0,),
        t_end,
        loads=(RampOnCoordinate(torque),),
        controllers=tuple((stage, 1) for stage in stages),
        period=1.0 / rate,
    )
