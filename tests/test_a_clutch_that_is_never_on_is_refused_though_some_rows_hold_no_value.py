"""A pressure that applies in some rows alone is judged by these."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.fitting_map import _check_closed
from simpter_hybrid.problems import InvalidInput

NAN = float("nan")


def check(threshold, *runs):
    made = [Some(channels={"pressure": np.array(values)}) for values in runs]
    declared = Some(name="model", clutches=[Some(threshold=threshold)])
    _check_closed(Some(runs=made), declared)


@pytest.mark.parametrize("runs", [[(NAN, 1.0)], [(1.0, NAN), (NAN, 0.5)], [(NAN, NAN), (0.0, 1.0)]])
def test_by_the_most_that_was_told(runs):
    check(0.9, *runs)
    with pytest.raises(InvalidInput, match=r"never on in this recording .*at most 1 V"):
        check(5.0, *runs)


def test_rows_without_any_value_are_as_no_pressure_at_all():
    check(-1.0, (NAN, NAN))
    with pytest.raises(InvalidInput, match="never on"):
        check(0.0, (NAN, NAN))
