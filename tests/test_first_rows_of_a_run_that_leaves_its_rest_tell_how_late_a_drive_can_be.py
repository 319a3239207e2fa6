"""The first rows of a run are ignored where a late driver may do what came before the record."""

import numpy as np
import pytest

from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.windows import rows_untold
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun

TIME = np.arange(0.0, 2.0, 0.01)
#: Spun up in 60 ms from the first row on; and the same motor at its speed.
SPUN = TIME - 0.06 * (1.0 - np.exp(-TIME / 0.06))
STEADY = np.full(TIME.size, 12.0)
CHANGED = 12.0 - 6.0 * np.minimum(TIME / 0.05, 1.0)


@pytest.mark.parametrize(
    ("position", "duty", "ignored"),
    [(SPUN, STEADY, 0), (TIME, STEADY, 5), (SPUN, 0.0 * TIME, 5), (SPUN, CHANGED, 5)],
    ids=["new at rest", "in motion", "nothing told", "changed at once"],
)
def test_only_rows_that_a_drive_from_before_may_rule_are_ignored(position, duty, ignored):
    channels = {"position": position, "speed": np.gradient(position, TIME), "duty": duty}
    run = RecordedRun("run", "run", "run", (0, TIME.size), TIME, channels)
    assert rows_untold(run, AxisSignals()) == ignored
