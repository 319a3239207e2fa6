"""The circular path of the first simulation of the robot, with ideal or real clutches."""

from __future__ import annotations

from ..clutch import Clutch
from ..controllers.impedance_circle import ImpedanceToCircle
from ..controllers.lookup import LookupTable
from ..devices.pter import Pter
from ..devices.pter_equations import inverse_kinematics
from ..known_units import INCH, LBF
from ..laws import LBF_IN, LinearTorque, TestbedTorque
from ..loads.circle_operator import CircleOperator
from ..scenario import Scenario
from ..stop import Singular
from .inputs import Inputs, nominal

#: The circle is not printed: this one fills a good part of the workspace [in].
CENTRE, RADIUS = (0.0, 38.0), 8.0
CAPACITY = 600 * LBF_IN


def circle(ideal: bool = True, inputs: Inputs | None = None, t_end: float = 6.0) -> Scenario:
    """An operator pushes along a circle and sways across it (thesis 2.3).

    Ideal clutches deliver at once what is asked, up to their capacity and against their slip only:
    the two checks of the Charles/Davis simulation. They stick where their slip vanishes.

    Parameters
    ----------
    ideal : bool
        Ideal clutches; else the clutches of chapter 5 behind the same controller.
    inputs : Inputs, optional
    t_end : float
        Duration [s].
    """
    x = nominal() if inputs is None else inputs
    centre = {"x": CENTRE[0] * INCH, "y": CENTRE[1] * INCH}
    q = [0.0, 0.0]
    start = ((CENTRE[0] + RADIUS) * INCH, CENTRE[1] * INCH)
    inverse_kinematics(*start, 1, [0.0, 0.0, 0.0, x.l_a, x.l_d], q)
    if ideal:
        clutch = Clutch(LinearTorque(CAPACITY), time_constant=0.0, delay=0.0, threshold=0.0)
    else:
        clutch = Clutch(TestbedTorque(), time_constant=x.time_constant, delay=x.delay)
    selector = ImpedanceToCircle(x.stiffness, x.damping, **centre, radius=RADIUS * INCH)
    return Scenario(
        "circle-ideal" if ideal else "circle-real",
        Pter(x.alpha, x.beta, x.gamma, x.l_a, x.l_d),
        (clutch,) * 4,
        tuple(q),
        (0.0, 0.0),
        t_end,
        loads=(CircleOperator(7 * LBF, 5 * LBF, 0.5, 0.0, **centre),),
        controllers=((selector, 1), (LookupTable(CAPACITY), 1)),
        stops=(Singular(),),
        period=1.0 / x.rate,
    )
