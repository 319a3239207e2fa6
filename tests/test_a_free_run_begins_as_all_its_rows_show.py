"""The start of a run that nothing drives is fitted to the run, and says nothing of a model."""

from dataclasses import replace

import numpy as np
import pytest
from free_swing import NOISE, START, TIME, TURN, Swing, swing, swung

from simpter_hybrid.identification.fitting.residual import deviation
from simpter_hybrid.identification.rigs.free_start import begun_near, started
from simpter_hybrid.identification.rigs.input_noise import InputNoise


class Quiet(InputNoise):
    """No input has noise."""

    def moved(self, values, replays, seeds):
        for _ in seeds:
            yield [{"position": np.zeros(r.time.size)} for r in replays]


def test_within_what_noise_of_all_rows_allows():
    (found,) = started(Swing().simulated, {"turn": TURN}, [swung()])
    # Two parameters of 1200 rows: sd of the amplitude NOISE sqrt(2/1200) times 1.5 for its fading.
    assert found.notes["start"][0] == pytest.approx(START[0], abs=4 * 6e-5)
    assert found.notes["start"][1] == pytest.approx(START[1], abs=4 * 6e-5 * TURN)


def test_unless_it_is_known():
    run = swung(start_free=False)
    assert started(Swing().simulated, {"turn": TURN}, [run]) == [run]


def test_and_another_start_is_no_evidence():
    noise = Quiet(Swing(), None, None)
    (run,) = noise.weighed({"turn": TURN}, [swung()])
    seen = run.observed["position"]
    near, far = (deviation(seen, swing(START + np.array(by))) for by in ((0.0, 0.0), (5e-4, -4e-3)))
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
        (run,) = noise.weighed({"turn": TURN}, [swung(start_free=free)])
        seen = run.observed["position"]
        left.append(np.sqrt(np.mean(deviation(seen, seen.values - NOISE * fast) ** 2)))
    assert left[0] == pytest.approx(left[1], rel=1e-3)  # it is orthogonal to both to 1e-2


def test_a_rate_that_is_off_is_one():
    noise = Quiet(Swing(), None, None)
    (run,) = noise.weighed({"turn": TURN}, [swung()])
    off = deviation(run.observed["position"], swing(START, 1.003 * TURN))
    assert np.sqrt(np.mean(off**2)) > 1.5 * NOISE


def test_a_model_predicts_it_from_the_start_that_is_best_for_it():
    # Near where the run says, and as if that had been fitted for long: to a part of the noise.
    free, held = swung(), swung(start_free=False)
    told = begun_near(Swing().simulated, {"turn": TURN}, [held, free, held])["position"]
    best = started(Swing().simulated, {"turn": TURN}, [free])
    assert told[1] == pytest.approx(Swing().simulated({"turn": TURN}, best)["position"][0],
                                    abs=0.02 * NOISE)  # fmt: skip
    for other in (told[0], told[2]):
        assert np.array_equal(other, swing(held.notes["start"]))


def test_no_run_changes_what_is_predicted_of_another():
    one, far = swung(), swung()
    far = replace(far, notes={**far.notes, "start": START + np.array([0.1, 1.0])})
    alone = begun_near(Swing().simulated, {"turn": 1.02 * TURN}, [one])["position"][0]
    beside = begun_near(Swing().simulated, {"turn": 1.02 * TURN}, [far, one])["position"][1]
    assert np.array_equal(alone, beside)
