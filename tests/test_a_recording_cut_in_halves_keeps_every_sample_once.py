"""One run that has to fit and to select is cut in two, each half with its own start."""

import numpy as np

from simpter_hybrid.identification.axis.halves import halves
from simpter_hybrid.identification.fitting.replay import Observation, Replay, Restart


def test_a_recording_cut_in_halves_keeps_every_sample_once():
    time = np.arange(100) * 0.01
    speed = np.sin(time)
    replay = Replay(
        "run 1", "run 1", time, {"drive": np.cos(time)},
        {"speed": Observation(speed, 0.1, np.ones(100, bool))},
        tuple(Restart(k, float(k), 0.5 * k) for k in (25, 50, 75)),
        notes={"position": -np.cos(time), "start": np.array([1.0, 2.0])},
    )  # fmt: skip
    first, second = halves(replay)
    joined = [h.observed["speed"].values for h in (first, second)]
    assert np.array_equal(np.concatenate(joined), speed)
    assert first.time[0] == second.time[0] == 0.0
    assert second.notes["start"].tolist() == [50.0, 25.0]
    assert [r.index for r in first.restarts] == [25]
    assert [r.index for r in second.restarts] == [25]


def test_each_window_keeps_the_steepest_line_of_its_start():
    time = np.arange(100) * 0.01
    windows, slopes = (0, 25, 50, 75), (1.0, 2.0, 3.0, 4.0)
    seen = Observation(time, 0.1, np.ones(100, bool), windows=windows, slopes=slopes)
    restarts = tuple(Restart(k, 0.0, 0.0) for k in windows[1:])
    notes = {"position": time, "start": np.zeros(2)}
    replay = Replay("run", "run", time, {}, {"position": seen}, restarts, notes=notes)
    first, second = (half.observed["position"] for half in halves(replay))
    assert (first.windows, first.slopes) == ((0, 25), (1.0, 2.0))
    assert (second.windows, second.slopes) == ((0, 25), (3.0, 4.0))
