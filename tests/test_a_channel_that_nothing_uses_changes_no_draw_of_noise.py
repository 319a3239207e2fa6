"""A logged channel that no model reads has no say: not by what is drawn for it either."""

from dataclasses import replace

import numpy as np
from axis_recordings import recorded_axis

from simpter_hybrid.identification.rigs.input_noise import InputNoise


def test_the_others_get_the_same_noise_with_and_without_it(tmp_path):
    plain = recorded_axis(tmp_path, ())
    channels = plain.map.channels
    humidity = replace(channels["torque"], signal="humidity", column="humidity")
    run = plain.runs[0]
    seen = {"humidity": np.linspace(0.4, 0.5, run.time.size), **run.channels}
    more = replace(
        plain,
        map=replace(plain.map, channels={"humidity": humidity, **channels}),
        runs=(replace(run, channels=seen), *plain.runs[1:]),
    )
    sensed = frozenset({"torque"})
    with_it, without = (
        InputNoise(None, recording, None, sensed=sensed).disturbed(3).runs[0].channels
        for recording in (more, plain)
    )
    assert not np.array_equal(without["torque"], run.channels["torque"])
    for name in without:
        assert np.array_equal(with_it[name], without[name])
