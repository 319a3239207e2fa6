"""A force that a tester's coarse sensor logs, and a recording of an axis that was moved with it."""

import numpy as np
from axis_recordings import written
from moved_axis import MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.prescribed_bench import prescribed_bench
from simpter_hybrid.identification.recordings.groups import groups_of

TIME = np.arange(0.0, 8.0, 0.004)
FORCE = 5.0 * np.sin(1.3 * TIME)
#: What the sensor rounds to [N].
STEP = 0.5


def rounded_force(noise):
    """The force with noise of this deviation, as the sensor logs it."""
    noisy = FORCE + np.random.default_rng(1).normal(0.0, noise, TIME.size)
    return STEP * np.round(noisy / STEP)


def moved_bench(folder, noise):
    """A tester's recording of one run each to fit, select and report on."""
    rows = ["run,t,x,F"]
    for run in range(3):
        x = 0.03 * np.sin(1.3 * TIME + run)
        rows += [
            f"{run},{a:.3f},{b:.8f},{c:.5f}"
            for a, b, c in zip(TIME, x, rounded_force(noise), strict=True)
        ]
    recording = written(folder, rows, MAP)
    return prescribed_bench(recording, parse(model(0.2, 'coulomb = "5 N"')), groups_of(recording))
