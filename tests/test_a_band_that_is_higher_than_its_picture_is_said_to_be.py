"""A band of few runs may be many times as high as its curve: that it goes on is said."""

from types import SimpleNamespace as Named

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.plots.diagnosis import dependence

COURSE = np.linspace(0.0, 30.0, 12)


def _found(band):
    curve = Dependence(
        "time", 0.3, 0.005, 100, COURSE, np.sin(COURSE), 0.0 * COURSE, band=band + 0.0 * COURSE
    )
    seen, verdict = {"force": (curve,)}, Named(kind="unknown", accepted=None)
    only = Named(before=seen, after=seen, logged={}, verdict=verdict)
    predictor = Named(declared=Named(device=Named(coordinate_dimensions=("angle",))))
    done = Named(rounds=(only,), refitted=Named(predictor=predictor), verdict=verdict)
    return Named(search=done, empirical=None)


@pytest.mark.parametrize(("band", "said"), [(0.01, False), (5.0, True)])
def test_in_the_legend(band, said):
    picture = dependence(_found(band))
    (legend,) = picture.legends
    assert ("beyond the axes" in legend.get_texts()[-1].get_text()) is said
    FigureCanvasAgg(picture).draw()
    assert legend.get_window_extent().x0 > picture.bbox.x0 + 0.4 * picture.bbox.width
