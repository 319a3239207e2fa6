"""Of one kind alone repeated runs may differ by less than a perfect model leaves of all."""

from types import SimpleNamespace as Some

import pytest
from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.floor import Floors, weighted_floor
from simpter_hybrid.identification.reporting.held_out_data import errors_of_experiments


def test_beside_errors_that_are_over_the_floor():
    fitted = [toy_replay("1", 1), toy_replay("2", 2), toy_replay("3", 3, experiment="b")]
    told = {"after": {"a": 2.0, "b": 4.0}}
    found = Some(
        split=Some(report=fitted), error_by_experiment=told, fitted=fitted,
        floors=Floors(1.0, 1.0, 0.5),
    )  # fmt: skip
    rows = errors_of_experiments(found)
    assert rows["a"] == pytest.approx({"after": 4.0, "floor": weighted_floor(fitted) / 0.5})
    assert rows["b"] == {"after": 8.0}
