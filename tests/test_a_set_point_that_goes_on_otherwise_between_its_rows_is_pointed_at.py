"""Rows hold until the next, says the map; the set point was a smooth one, logged now and then."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.compiled import simulate
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording
from simpter_hybrid.identification.reporting.doubted_sentence import doubted_sentence
from simpter_hybrid.measuring.sampling import sample

ROW = 0.01


def _run(k: int) -> RecordedRun:
    """A sine, which the servo reads every 2 ms; logged every fifth time."""
    ticks, time = np.arange(0.0, 4.0, 0.002), np.arange(0.0, 3.9, ROW)
    wanted = 1.5 * np.sin((2.0 + 0.7 * k) * ticks)
    model = declared_axis()
    servo, stage = model.controllers[0]
    points = tuple(zip(ticks.tolist(), wanted.tolist(), strict=True))
    servo = replace(servo, points=points, proportional=6.0, limit=10.0)
    angle = sample(simulate(replace(model, controllers=((servo, stage),))), time).q[:, 0]
    angle = angle + np.random.default_rng(k).normal(0.0, 2e-4, time.size)
    channels = {"position": angle, "reference": np.interp(time, ticks, wanted)}
    return RecordedRun(f"take {k}", f"take {k}", f"take {k}", (0, time.size), time, channels)


@pytest.mark.parametrize(
    ("held", "doubted"),
    [pytest.param("after", True, marks=pytest.mark.slow), ("sampled", False)],
)
def test_the_right_reading_is_named(held, doubted):
    model = declared_axis()
    servo, stage = model.controllers[0]
    model = replace(model, controllers=((replace(servo, proportional=6.0, limit=10.0), stage),))
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "rad", role, held=held) for n, role in roles.items()}
    channels["position"] = replace(channels["position"], held="sampled", may_rest=True)
    split = {"fit": ("take 0",), "select": ("take 1",), "report": ("take 2",)}
    described = RecordingMap("map", channels["position"], channels, split=split)
    found = diagnose(Recording("file", described, tuple(map(_run, range(3)))), model, ())
    assert [doubt.change.held for doubt in found.doubts] == (["sampled"] if doubted else [])
    assert ('held = "sampled"' in doubted_sentence(found.doubts)) == doubted
    assert (found.search.verdict.kind == "nothing missing") != doubted
