"""What takes minutes to stop is planned to be let go for as long, and at rest only where known."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.axis.told_plan import motion_reach, releases

TIME = np.arange(0.0, 240.5, 0.5)


def run():
    notes = {"position": np.cumsum(8.0 - TIME / 30.0) * 0.5, "speed": 8.0 - TIME / 30.0}
    return Some(time=TIME, notes=notes, before=None, stamp=0.0)


@pytest.mark.parametrize(("alone", "longest"), [(True, 240.0), (False, 12.0)])
def test_only_what_is_let_alone_is_planned_that_long(alone, longest):
    assert motion_reach([run()], 78.0, alone=alone).time[-1] == longest


@pytest.mark.parametrize("summed", [True, False])
def test_it_is_let_go_at_rest_only_where_its_place_is_known(summed):
    recording = Some(channels={AxisSignals().position: Some(summed=summed)}, runs=())
    planned = releases(recording, motion_reach([run()], 78.0, alone=True))
    assert any("at rest" in name for name in planned) is not summed
    assert "let go at the largest speed, backwards" in planned
