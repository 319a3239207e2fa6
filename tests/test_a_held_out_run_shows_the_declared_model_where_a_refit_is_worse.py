"""Where the refitted model errs more than the declared one, the picture has both."""

import numpy as np
import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification.held_out_predictions import HeldOutPredictions, most_telling
from simpter_hybrid.plots import held_out as picture


@pytest.mark.parametrize("worse", [True, False])
def test_its_line_is_in_the_legend(monkeypatch, worse):
    monkeypatch.setattr(picture, "sticking", lambda *_: {})
    replays = [toy_replay("run", 1)]
    refitted, declared = (ToyRig().predict({"scale": x}, replays) for x in (1.4, 1.0))
    telling = most_telling(replays, refitted, refitted)
    corrected = type("Model", (), {"predictor": None, "values": {}})()
    told = HeldOutPredictions(
        replays, refitted, refitted, corrected, telling, declared if worse else None
    )
    (drawn, *_) = picture.held_out(told).axes
    lines = {line.get_label(): line.get_ydata() for line in drawn.lines}
    assert ("declared" in lines) is worse
    assert not worse or np.array_equal(lines["declared"], declared["torque"][0])
