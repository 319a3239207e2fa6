"""Off the floor an effect that leaves less does not hide a declared value that may be all."""

import pytest

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.fitting.fitted_model import Trial
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.tracing.rivals import rivals_of


@pytest.mark.parametrize(
    ("scale", "other", "floor", "told"),
    [
        (0.55, 0.56, 0.1, {"torque-scale", "command-scale"}),
        (0.55, 0.55, 0.1, {"torque-scale", "command-scale"}),
        (0.56, 0.55, 0.1, {"command-scale"}),  # it does worse than what is kept
        (0.55, 0.99, 0.1, set()),  # without another rival the effect is plain
        (0.505, 0.509, 0.5, {"command-scale"}),  # at the floor evidence is fine enough
    ],
)
def test_it_is_kept_beside_a_rival_that_does_no_better(scale, other, floor, told):
    known = {c.name: c for c in rotor_library(load(find_model("testbed")))}
    left = {"stribeck": 0.5, "torque-scale": scale, "command-scale": other}
    trials = [Trial(known[name], None, x, 1 - x, 1.0) for name, x in left.items()]
    assert {t.candidate.name for t in rivals_of(trials[0], trials, floor)} == told
