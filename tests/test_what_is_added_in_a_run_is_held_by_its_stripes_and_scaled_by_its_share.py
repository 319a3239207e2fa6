"""A run with 5 N m more friction than its torque overcomes: it stands still, whoever asks."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL, written

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.declared_off import off_by_a_share
from simpter_hybrid.plots.sticking import sticking

TWO = MAP.replace('report = ["take 2"]', 'report = ["take 2", "take 3"]')
MORE = TWO.replace('"lbf*in"', '"N*m"') + (
    '[channels.more]\ncolumn = "more"\nunit = "N*m"\nsign = 1\nrole = "constant"\n'
    'adds_to = "clutch.1.torque.coulomb"\n'
)
COULOMB = "clutch.1.torque.coulomb"


@pytest.fixture(scope="module")
def bench(tmp_path_factory):
    rows = ["take,ms,angle,torque,more"]
    for take, more in enumerate((0.0, 0.0, 0.0, 5.0)):
        for k in range(400):
            at = 20.0 * np.sin(0.02 * k) * (more == 0.0)
            rows.append(f"{take},{5 * k},{at + 0.01 * (k % 3):.4f},{np.sin(0.05 * k):.4f},{more}")
    recording = as_recorded(written(tmp_path_factory.mktemp("more"), rows, MORE))
    declared = parse(MODEL.replace('weight = "0.5 N*m"\n', ""))
    return bench_of(recording, declared, groups_of(recording))


def test_its_stripe_says_stuck_where_its_prediction_does_not_move(bench):
    values = {p.name: p.value for p in bench.predictor.parameters}
    (free, *_), (*_, held) = bench.parts["fit"], bench.parts["report"]
    (told,) = bench.predictor.simulated(values, [held])["position"]
    (stuck,) = sticking(bench.predictor, values, held).values()
    assert np.mean(np.diff(told) == 0.0) > 0.9  # but where a window begins in motion
    assert np.mean(stuck) > 0.9
    (moving,) = sticking(bench.predictor, values, free).values()
    assert np.mean(moving) < 0.5


def test_a_share_of_the_friction_is_of_the_whole_as_a_tolerance_is(bench):
    scale = off_by_a_share("scale", (COULOMB,), (-0.9, 1.0, 0.02), 0.05, "f", "friction", (), "")
    model, factor = bench.predictor.extended(scale), "Coulomb friction"
    at = model.runner.names[COULOMB]
    (*_, run) = bench.parts["report"]
    for values in ({factor: 1.0, "scale.share": 0.5}, {factor: 1.5, "scale.share": 0.0}):
        _, given = model.played(values, run)
        assert given.parameters[at] == pytest.approx(1.5 * (0.2 + 5.0))
