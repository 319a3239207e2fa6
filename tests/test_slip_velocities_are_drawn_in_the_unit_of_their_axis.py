"""The thesis's units are inches: what a slide slips is drawn in in/s where the axis says so."""

import matplotlib.pyplot as plt
import numpy as np
import pytest
from devices_for_tests import always_on

from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.plots.clutches import slip_velocities
from simpter_hybrid.plots.display import THESIS
from simpter_hybrid.scenario import Scenario


def test_one_metre_a_second_is_39_inches():
    slide = Scenario("slide", LinearAxis(2.0), (always_on(1.0, 1.0),), (0.0,), (1.0,), 0.5)
    run = simulate(slide)
    picture = slip_velocities(run, sample(run, np.linspace(0.0, 0.5, 20)), THESIS)
    ax = picture.axes[0]
    courses = [np.asarray(line.get_ydata()) for line in ax.lines]
    drawn = max(course.max() for course in courses if np.isfinite(course).all())
    assert ax.get_ylabel() == "slip [in/s]"
    assert drawn == pytest.approx(1.0 / 0.0254)
    assert ax.get_ylim()[1] > drawn
    plt.close(picture)
