"""What PTER's controllers write at one instant, through the assembled model."""

import math

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.pter import Pter
from simpter_hybrid.laws import LBF_IN, TestbedTorque
from simpter_hybrid.scenario import Scenario

INCH, LBF = 0.0254, 4.4482216152605
PTER = Pter(150 * LBF_IN, 45 * LBF_IN, -12 * LBF_IN, 36.4 * INCH, 24.1 * INCH)
LINE = {"x": 0.0, "y": 24 * INCH, "angle": 0.0}


def scenario(*controllers, loads=()) -> Scenario:
    """PTER with controllers that run at every sample, in order."""
    stages = tuple((c, 1) for c in controllers)
    clutches = (Clutch(TestbedTorque()),) * 4
    return Scenario("test", PTER, clutches, (0.0, 0.0), (0.0, 0.0), 1.0, loads, stages, period=0.01)


class Instants:
    """Calls the controllers of a scenario at given states; memory and held inputs live on."""

    def __init__(self, run: Scenario) -> None:
        self.md = run.python_model()
        self.y, self.w = run.initial(lambda k: [0.0] * k, lambda k: [0] * k)
        self.m = run.device.m
        self.k = 0

    def __call__(self, q, qd, t=0.0, tau=(0.0, 0.0, 0.0, 0.0)):
        """Held inputs after the controllers have acted: commands (m,), then the others."""
        md, w = self.md, self.w
        n = md.n
        self.y[:n], self.y[n : 2 * n] = list(q), list(qd)
        md.control(self.k, t, self.y, [*tau, 0.0], md.p, md.rec, w.s, w.held, w.mem)
        self.k += 1
        return w.held[: self.m], w.held[self.m : -1]


def tip_of(q):
    """Tip [m] at link angles [rad], from the thesis's equations (1) and (2)."""
    a, d = PTER.l_a, PTER.l_d
    return (
        a * math.cos(q[0]) - d * math.sin(q[1]),
        a * math.sin(q[0]) + d * math.cos(q[1]),
    )
