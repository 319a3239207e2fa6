"""What noise of an input does to a run that is followed whole stands in the floor."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from axis_recordings import recorded_axis

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.rigs.input_noise import InputNoise

#: Stiffness of a spring whose end is recorded; noise of that; what else a force carries.
STIFF, NOISE, SD = 40.0, 0.01, 0.3


@dataclass(frozen=True)
class Spring:
    """A force in proportion to the recorded input."""

    stiffness: float = STIFF

    def simulated(self, values, replays):
        return {"force": [self.stiffness * r.inputs["torque"] for r in replays]}


def _made(recording):
    found = []
    for run in recording.runs:
        torque = run.channels["torque"]
        seen = Observation(STIFF * torque, SD, np.arange(torque.size) % 2 == 0)
        inputs, observed = {"torque": torque}, {"force": seen}
        found.append(Replay(run.name, run.experiment, run.time, inputs, observed))
    return found


@pytest.mark.parametrize("stiffness", [STIFF, 0.0])
def test_beside_the_noise_of_the_force_itself(tmp_path, stiffness):
    recording = recorded_axis(tmp_path, ())
    noisy = replace(recording.channels["torque"], held="sampled", noise=NOISE)
    channels = {**recording.map.channels, "torque": noisy}
    recording = replace(recording, map=replace(recording.map, channels=channels))
    noise, replays = InputNoise(Spring(stiffness), recording, _made), _made(recording)
    assert noise.weighed({}, replays) == replays
    expected = np.hypot(1.0, stiffness * NOISE / SD)
    # Three draws of some hundred rows or more.
    assert noise.floors({}, {"fit": replays})["fit"] == pytest.approx(expected, rel=0.05)


def test_a_run_of_which_nothing_is_compared_says_nothing(tmp_path):
    recording = recorded_axis(tmp_path, ())
    noisy = replace(recording.channels["torque"], held="sampled", noise=NOISE)
    channels = {**recording.map.channels, "torque": noisy}
    recording = replace(recording, map=replace(recording.map, channels=channels))
    noise, replays = InputNoise(Spring(STIFF), recording, _made), _made(recording)
    silent = replace(replays[0].observed["force"], keep=np.zeros(replays[0].time.size, bool))
    some = [replace(replays[0], observed={"force": silent}), *replays[1:]]
    assert noise.floors({}, {"fit": some})["fit"] == pytest.approx(
        noise.floors({}, {"fit": replays})["fit"], rel=0.05
    )
