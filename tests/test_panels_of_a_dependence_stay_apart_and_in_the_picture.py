"""However many rounds and however long the names: nothing is cut off, nothing overlaps."""

from itertools import combinations
from types import SimpleNamespace as Named

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.plots.diagnosis import dependence

NAMES = [
    ("friction", "displacement_since_reversal"),
    ("breakaway", "neighbour_command_rate"),
    ("joint_2", "other_acceleration"),
    ("ringing", "breakaway"),
    ("friction", "run"),
]


def _seen(name, size):
    course = np.linspace(-1e-3, 30.0, 12)
    return Dependence(name, 0.999, 0.001, 100, course, size * np.sin(course), 0.0 * course)


def _found(names):
    none = {"verdict": Named(accepted=None), "logged": {}}
    rounds = [
        Named(before={b: (_seen(c, 0.1),)}, after={b: (_seen(c, 0.01),)}, **none) for b, c in names
    ]
    nothing_located = Named(before={"friction": ()}, after={"friction": ()}, **none)
    predictor = Named(declared=Named(device=Named(coordinate_dimensions=("angle",))))
    every, verdict = (nothing_located, *rounds), Named(kind="unknown")
    done = Named(rounds=every, refitted=Named(predictor=predictor), verdict=verdict)
    return Named(search=done, empirical=None)


@pytest.mark.parametrize("panels", [1, 2, 3, 4, 6])
def test_panels_stay_apart_and_in_the_picture(panels):
    picture = dependence(_found((2 * NAMES)[:panels]))
    FigureCanvasAgg(picture).draw()
    boxes = [ax.get_tightbbox() for ax in picture.axes]
    assert len(boxes) == panels
    for box in boxes:
        assert box.x0 >= 0.0
        assert box.y0 >= 0.0
        assert box.x1 <= picture.bbox.x1
        assert box.y1 <= picture.bbox.y1
    assert not any(one.overlaps(other) for one, other in combinations(boxes, 2))


def test_a_round_keeps_its_number():
    (panel,) = dependence(_found(NAMES[:1])).axes
    assert panel.get_title(loc="left").startswith("round 2:")
