from dataclasses import replace

import numpy as np
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.rigs.zeros import zero_of_position


def test_one_run_alone_has_it(tmp_path):
    predictor = ScenarioPredictor(declared_axis(), AxisRig())
    common = {p.name: p.value for p in predictor.parameters}
    name = predictor.parameters[0].name
    plain = axis_replays(recorded_axis(tmp_path, []), AxisSignals())[0]
    own = replace(plain, own={name: 1.2})
    both = predictor.predict({**common, name: 1.1}, [plain, own])["speed"]
    apart = [predictor.predict({**common, name: v}, [plain])["speed"][0] for v in (1.1, 1.1 * 1.2)]
    assert np.array_equal(both[0], apart[0])
    assert np.allclose(both[1], apart[1], rtol=0, atol=1e-12)  # 1.1 * 1.2 is rounded
    assert not np.allclose(both[0], both[1])


def test_one_run_alone_has_so_much_more_of_a_zero(tmp_path):
    zero = zero_of_position(declared_axis(), 1.0, turning=True)
    predictor = ScenarioPredictor(declared_axis(), AxisRig()).extended(zero)
    common = {p.name: p.value for p in predictor.parameters}
    plain = axis_replays(recorded_axis(tmp_path, []), AxisSignals())[0]
    own = replace(plain, own={zero.name: -0.05})
    seen = predictor.predict({**common, zero.name: 0.02}, [own])["speed"][0]
    apart, other = (predictor.predict({**common, zero.name: x}, [plain])["speed"][0]
                    for x in (0.02 - 0.05, 0.02))  # fmt: skip
    assert np.array_equal(seen, apart)
    assert not np.allclose(seen, other)
