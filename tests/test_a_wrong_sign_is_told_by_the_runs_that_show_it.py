"""A sign of the map: one run that it explains tells, if no other run errs more with it."""

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import rms, weighted_residuals
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recorded_run import RecordedRun
from simpter_hybrid.identification.recordings.recording import Recording
from simpter_hybrid.identification.turned_signs import _better_than, shows_it, turned_signs

#: Errors of a fast run and of two slow ones, which friction rules: as a geared motor's were.
READ, TURNED, IDLE = (np.array(x) for x in ([4.7, 3.0, 0.5], [0.3, 2.8, 0.1], [2.6, 0.1, 0.2]))


def test_though_all_together_say_little():
    together = np.sqrt(np.mean(TURNED**2) / np.mean(READ**2))
    assert together > 0.5  # what is asked of other factors
    assert shows_it(READ, TURNED, IDLE)


def test_not_where_one_run_errs_more():
    assert not shows_it(READ, TURNED + np.array([0.0, 0.3, 0.0]), IDLE)


def test_not_where_a_channel_that_does_nothing_explains_as_much():
    assert not shows_it(READ, TURNED, np.array([0.9, 0.1, 0.2]))


def test_a_run_of_which_nothing_is_compared_tells_nothing():
    read, turned, idle = (np.append(x, 0.0) for x in (READ, TURNED, IDLE))
    assert shows_it(read, turned, idle)


def test_or_by_a_drive_that_is_worse_than_none_and_better_turned_round():
    # What one turned round leaves has to be less than without a drive, and that less than half.
    assert _better_than(0.46) == pytest.approx(0.9 * 0.46)
    assert _better_than(0.9) == _better_than(np.nan) == 0.0


class Block:
    """A block that a force above its friction moves steadily, in closed form."""

    parameters = (Parameter("friction", 1.0, 0.3, 3.0, 0.1, 0.2, "1"),)

    def predict(self, values, replays):
        force = [r.inputs["torque"] for r in replays]
        beyond = [np.maximum(np.abs(f) - values["friction"], 0.0) for f in force]
        return {"speed": [b * np.sign(f) for b, f in zip(beyond, force, strict=True)]}


class Bench:
    """Runs as they were recorded."""

    predictor = Block()

    def made(self, recording, part):
        observed = [
            Observation(r.channels["speed"], 0.1, np.ones(50, bool)) for r in recording.runs
        ]
        return [
            Replay(r.name, r.name, r.time, {"torque": r.channels["torque"]}, {"speed": seen})
            for r, seen in zip(recording.runs, observed, strict=True)
        ]


def recorded(sign):
    """A fast run of friction 1, and a slow one that rests, which the model does not know."""
    runs = []
    for name, force, moves in (("fast", 5.0, 4.0), ("slow", 1.3, 0.0)):
        wave = np.sin(np.arange(50))
        seen = np.sign(wave) * np.maximum(force * np.abs(wave) - force + moves, 0.0)
        channels = {"torque": sign * force * wave, "speed": seen}
        runs.append(RecordedRun(name, name, name, (0, 50), 0.1 * np.arange(50.0), channels))
    roles = {"torque": "input", "speed": "measured"}
    channels = {n: ChannelMap(n, n, "", role) for n, role in roles.items()}
    described = RecordingMap("map.toml", ChannelMap("time", "t", "s", "input"), channels)
    return Recording("data.csv", described, tuple(runs))


@pytest.mark.parametrize(("sign", "asked"), [(-1.0, ["speed", "torque"]), (1.0, [])])
def test_it_is_asked_about_with_what_a_refit_leaves(sign, asked):
    recording, bench = recorded(sign), Bench()
    runs = bench.made(recording, "fit")
    error = rms(weighted_residuals(bench.predictor, {"friction": 1.0}, runs))
    found = turned_signs(
        bench, recording, {"friction": 1.0}, {"fit": runs, "select": runs}, "select", error
    )
    assert sorted(n for d in found for n in d.change.channels) == asked
    assert all(d.left < 0.3 and d.change.factor == -1.0 for d in found)
