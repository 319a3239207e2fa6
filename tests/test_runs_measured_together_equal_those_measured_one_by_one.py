"""The studies' measures on a grid against the library's own of single reference runs."""

from dataclasses import fields

import numpy as np
import pytest

pytest.importorskip("llvmlite", reason="studies need the compiled engine")

from simpter_hybrid.engine import simulate
from simpter_hybrid.known_units import INCH
from simpter_hybrid.measuring.metrics import measures
from simpter_hybrid.rigs.inputs import drawn, nominal
from simpter_hybrid.rigs.line import line
from simpter_hybrid.studies.batch import STEP, measured
from simpter_hybrid.studies.variants import alike


@pytest.mark.slow
def test_two_routes_to_the_same_numbers():
    # Inputs with another number of sinusoids and other lengths of links: one model all the same.
    inputs = [nominal(), next(x for x in drawn(8) if len(x.frequencies) == 2)]
    runs = [alike(line("impedance", 0.16, x)) for x in inputs]
    found = measured(runs)
    for k, run in enumerate(runs):
        one = measures(simulate(run), STEP)
        assert found.reached[k]
        assert found.time[k] == pytest.approx(one.run_time, abs=1e-8)
        # Half a chord at the end of the path is counted by one of them only.
        assert found.error[k] * INCH == pytest.approx(one.average_error, rel=2e-3)
        assert found.worst[k] * INCH == pytest.approx(one.max_error, rel=1e-6)
        assert found.work[k] == pytest.approx(one.energy_from_user, rel=2e-3)
        # At an event one takes the acceleration before it, the other that after it.
        assert found.jerk[k] * INCH == pytest.approx(one.average_jerk, rel=2e-2)
    assert np.ptp(found.time) > 0.01


@pytest.mark.parametrize(
    "other",
    [{"command": (0.0, 8.0, 0.0, 0.0), "excitation": (0.0, 8.0, 0.0, 0.0)}, {"event_limit": 3}],
    ids=["start", "limit"],
)
def test_whatever_they_differ_in(other):
    run = alike(line("impedance", 0.16))
    runs = [run, run.replace(**other)]
    found = measured(runs)
    alone = [measured([each]) for each in runs]
    for f in fields(found):
        assert np.array_equal(
            getattr(found, f.name), np.concatenate([getattr(each, f.name) for each in alone])
        )
    assert found.error[0] != found.error[1]
