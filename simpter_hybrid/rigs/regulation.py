"""One clutch regulated to a torque while a larger one drives it (thesis 5.4.3, Figure 50)."""

from __future__ import annotations

from ..clutch import Clutch
from ..controllers.dead_time import DeadTime
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
    law: TestbedTorque | None = None,
    excitation: float = 0.0,
    dead_time: float = 0.0,
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
    law : TestbedTorque, optional
        Torque map; (39) and (43) when left out.
    excitation : float
        At the start [V]; above 0.05 V the clutch starts engaged.
    dead_time : float
        From a command to its effect, rounded to 25ths of the controller's period [s].
    t_end : float
        Duration [s].
    name : str
    """
    x = nominal() if inputs is None else inputs
    fine = 25 if dead_time > 0.0 else 1
    stages = [
        (DesiredTorque(wanted), fine),
        (LookupTable(x.table_torque), fine),
        (TorqueFeedback(gain / LBF_IN), fine),
    ]
    if dead_time > 0.0:
        stages.append((DeadTime(round(dead_time * rate * fine) / (rate * fine)), 1))
    return Scenario(
        name,
        Testbed(2.0 * x.alpha),
        (Clutch(law or TestbedTorque(), time_constant=x.time_constant, delay=x.delay),),
        (0.0,),
        (0.0,),
        t_end,
        loads=(RampOnCoordinate(torque),),
        controllers=tuple(stages),
        excitation=(excitation,),
        period=1.0 / (rate * fine),
    )
