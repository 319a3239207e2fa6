"""Of an arm with clutches at joints and at the tip, whose angle is none, the joints' are tried."""

from devices_for_tests import always_on

from simpter_hybrid.devices.planar_arm import PlanarArm
from simpter_hybrid.identification.steady_rows import where_rows_are_steady
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.scenario import Scenario


def test_the_others_are_tried_on_all_clutches():
    arm = Scenario("arm", PlanarArm(), (always_on(1.0, 1.0),) * 5, (0.3, 0.9, 1.4), (0.0,) * 3, 1.0)
    tried = {c.name: c for c in where_rows_are_steady(tip_candidates(3, 5, (1.0,) * 3, 1, 1), arm)}
    assert "position-friction" not in tried  # one size for all clutches
    own = tried["position-friction by clutch"]
    assert [e.clutch for e in own.effects()] == [0, 1, 2]
    assert own.plain == ""
    assert len(tried["stribeck by clutch"].effects()) == 5
