"""A diagnosis of which a report reads nothing but two refitted numbers and an effect's size."""

from types import SimpleNamespace

from simpter_hybrid.identification.fitting.predictor import Parameter

MASS = Parameter("mass", 1.0, 0.5, 1.5, 0.01, tolerance=0.05)
FRICTION = Parameter("friction", 1.0, 0.5, 1.5, 0.01, tolerance=0.2)
SIZE = Parameter("drag.coefficient", 0.0, -5.0, 5.0, 0.1)


def found(mass, friction, ports=(), driven=True, weight=0.0):
    device = SimpleNamespace(parameters=lambda: {"weight": weight})
    model = SimpleNamespace(
        predictor=SimpleNamespace(
            parameters=(MASS, FRICTION, SIZE),
            declared=SimpleNamespace(device=device, effects=()),
        ),
        values={"mass": mass, "friction": friction, "drag.coefficient": 4.0},
        effects=tuple(SimpleNamespace(acts_on=port) for port in ports),
    )
    recording = SimpleNamespace(map=SimpleNamespace(driven=driven))
    return SimpleNamespace(search=SimpleNamespace(corrected=model), recording=recording)
