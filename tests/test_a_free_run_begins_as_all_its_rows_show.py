"""The start of a run that nothing drives is fitted to the run, and says nothing of a model."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import deviation
from simpter_hybrid.identification.rigs.free_start import begun_near, started
from simpter_hybrid.identification.rigs.input_noise import InputNoise

TURN, DECAY, NOISE = 8.7, 0.05, 1e-3
TIME = 0.01 * np.arange(1200)
START = np.array([0.02, -0.11])


def _swing(start, turn=TURN):
    rate = np.sqrt(turn**2 - DECAY**2)
    fade = np.exp(-DECAY * TIME)
    sine = (start[1] + DECAY * start[0]) / rate
    return fade * (start[0] * np.cos(rate * TIME) + sine * np.sin(rate * TIME))


class Swing:
    """A damped oscillator in closed form."""

    def simulated(self, values, replays):
        return {"position": [_swing(r.notes["start"], values["turn"]) for r in replays]}


class Quiet(InputNoise):
    """No input has noise."""

    def moved(self, values, replays, seeds):
        for _ in seeds:
            yield [{"position": np.zeros(r.time.size)} for r in replays]


def _run(start_free=True):
    seen = _swing(START) + NOISE * np.random.default_rng(5).standard_normal(TIME.size)
    observed = {"position": Observation(seen, NOISE, TIME >= 0.0, windows=(0,), lines=False)}
    notes = {"position": seen, "speed": np.gradient(seen, TIME)}
    notes["start"] = START + np.array([2e-3, 0.02])  # as a polynomial had it
    return Replay("run", "run", TIME, {}, observed, notes=notes, start_free=start_free)


def test_within_what_noise_of_all_rows_allows():
    (found,) = started(Swing().simulated, {"turn": TURN}, [_run()])
    # Two parameters of 1200 rows: sd of the amplitude NOISE sqrt(2/1200) times 1.5 for its fading.
    assert found.notes["start"][0] == pytest.approx(START[0], abs=4 * 6e-5)
    assert found.notes["start"][1] == pytest.approx(START[1], abs=4 * 6e-5 * TURN)


def test_unless_it_is_known():
    run = _run(start_free=False)
    assert started(Swing().simulated, {"turn": TURN}, [run]) == [run]


def test_and_another_start_is_no_evidence():
    noise = Quiet(Swing(), None, None)
    (run,) = noise.weighed({"turn": TURN}, [_run()])
    seen = run.observed["position"]
    near, far = (
        deviation(seen, _swing(START + np.array(by))) for by in ((0.0, 0.0), (5e-4, -4e-3))
    )
    # Linear: a start moves an oscillator in proportion.  A millionth is left of 8 deviations.
    assert near == pytest.approx(far, abs=1e-5 * NOISE)
    assert np.sqrt(np.mean(near**2)) == pytest.approx(NOISE, rel=0.1)


def test_noise_of_what_drives_counts_as_much_beside_a_free_start():
    fast = np.sin(40.0 * TIME)  # like no start

    class Driven(InputNoise):
        def moved(self, values, replays, seeds):
            for sign in (1.0, -1.0, 1.0):
                yield [{"position": sign * 3.0 * NOISE * fast} for _ in replays]

    noise = Driven(Swing(), None, None)
    left = []
    for free in (True, False):
        (run,) = noise.weighed({"turn": TURN}, [_run(start_free=free)])
        seen = run.observed["position"]
        left.append(np.sqrt(np.mean(deviation(seen, seen.values - NOISE * fast) ** 2)))
    assert left[0] == pytest.approx(left[1], rel=1e-3)  # it is orthogonal to both to 1e-2


def test_a_rate_that_is_off_is_one():
    noise = Quiet(Swing(), None, None)
    (run,) = noise.weighed({"turn": TURN}, [_run()])
    off = deviation(run.observed["position"], _swing(START, 1.003 * TURN))
    assert np.sqrt(np.mean(off**2)) > 1.5 * NOISE


def test_a_model_predicts_it_from_the_start_that_is_best_for_it():
    # Near where the run says, and as if that had been fitted for long: to a part of the noise.
    free, held = _run(), _run(start_free=False)
    told = begun_near(Swing().simulated, {"turn": TURN}, [held, free, held])["position"]
    best = started(Swing().simulated, {"turn": TURN}, [free])
    assert told[1] == pytest.approx(Swing().simulated({"turn": TURN}, best)["position"][0],
                                    abs=0.02 * NOISE)  # fmt: skip
    for other in (told[0], told[2]):
        assert np.array_equal(other, _swing(held.notes["start"]))


def test_no_run_changes_what_is_predicted_of_another():
    one, far = _run(), _run()
    far = replace(far, notes={**far.notes, "start": START + np.array([0.1, 1.0])})
    alone = begun_near(Swing().simulated, {"turn": 1.02 * TURN}, [one])["position"][0]
    beside = begun_near(Swing().simulated, {"turn": 1.02 * TURN}, [far, one])["position"][1]
    assert np.array_equal(alone, beside)
