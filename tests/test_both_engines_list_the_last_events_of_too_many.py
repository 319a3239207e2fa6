"""A run that is given up for the number of its events says which came last."""

import pytest

from simpter_hybrid import compiled, engine
from simpter_hybrid.files.scenario_file import load


@pytest.mark.parametrize("simulate", [engine.simulate, compiled.simulate])
def test_the_last_three(simulate):
    found = simulate(load("line-y24", ["run.rtol=1e-6", "run.event_limit=4"]))
    assert "more than 4 events" in found.message
    assert found.message.count(" clutch (") == 3
    assert f"t = {found.events[-1].t!r} s {found.events[-1].kind} clutch" in found.message
