"""A rise below 0 is a fall: the sentence says so, as the name does not."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.reporting.other_ways import other_way


def _found(**values):
    named = {name.replace("__", ".").replace("_", "-"): v for name, v in values.items()}
    runs = [Some(time=0.002 * np.arange(10))]
    return Some(search=Some(corrected=Some(values=named)), fitted=runs)


@pytest.mark.parametrize(
    ("found", "name", "said"),
    [
        (_found(degressive_speed__rise=-0.3), "degressive-speed", " (here friction falls with"),
        (_found(degressive_speed__rise=0.3), "degressive-speed", ""),
        (_found(force_delay__delay=-0.004), "force-delay", " (here the sensor is early"),
        (_found(viscous_drag__coefficient=-1.0), "viscous-drag", ""),
    ],
)
def test_only_where_it_has_it(found, name, said):
    told = other_way(found, name, found.search.corrected.values)
    assert told.startswith(said)
    assert bool(told) == bool(said)


@pytest.mark.parametrize(("late", "held"), [(-0.0005, True), (-0.002, False), (-0.0001, False)])
def test_part_of_a_row_is_what_a_drive_that_holds_makes_late(late, held):
    found = _found(force_delay__delay=late)
    told = other_way(found, "force-delay", found.search.corrected.values)
    assert ("as a drive that holds" in told) is held
