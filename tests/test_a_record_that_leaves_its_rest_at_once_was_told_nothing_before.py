"""What a driver was told before a record began at rest, by whether it left under that drive."""

import numpy as np
import pytest

from simpter_hybrid.identification.rigs.begun_at_rest import left_as_told

TIME = np.arange(0.0, 2.0, 0.01)
#: Counts of a motor that is told 240 from the first row on, and spins up in 60 ms.
SPUN = 100.0 * np.round(TIME - 0.06 * (1.0 - np.exp(-TIME / 0.06)), 2)
#: An arm that is held for half a second, and then lifted.
LIFTED = np.clip(TIME - 0.5, 0.0, None)


@pytest.mark.parametrize(
    ("position", "told", "left"),
    [
        (SPUN, np.full(TIME.size, 240.0), True),
        (SPUN, np.where(TIME < 1.0, 240.0, 160.0), True),
        (LIFTED, 3.0 + 0.3 * (TIME > 0.45), False),
        (SPUN, 240.0 - SPUN, None),
    ],
    ids=["steady", "one step later", "held against its weight", "changed by a servo at once"],
)
def test_a_drive_under_which_it_leaves_is_new_to_it(position, told, left):
    assert left_as_told(TIME, position, told) is left
