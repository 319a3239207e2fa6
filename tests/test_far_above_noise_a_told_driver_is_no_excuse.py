"""A driver may give much by itself; far above noise of a sensor something is missing somewhere."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.lack_sentences import lack_sentence
from simpter_hybrid.identification.tracing.limits import SIMULATED_AXIS
from simpter_hybrid.identification.tracing.verdict import Verdict


def position(step=None, noise=None):
    """A recording of a position, of which the map states the step or the noise."""
    return SimpleNamespace(
        channels={"position": SimpleNamespace(role="measured", step=step, noise=noise)},
        map=SimpleNamespace(driven=True),
    )


def said(ratio, told, recording=None):
    model = SimpleNamespace(select_error=ratio, residuals=np.full(9, ratio))
    search = SimpleNamespace(
        verdict=Verdict("lack or noise"), refitted=model, corrected=model, floor=1.0, rounds=()
    )
    return lack_sentence(
        SimpleNamespace(
            search=search, limits=SIMULATED_AXIS._replace(told=told), floors=Floors(1.0, 1.0, 1.0),
            taken_back=None, only_held_out=False, recording=recording, remarks=(), off_pace=False,
            split=SimpleNamespace(report=[SimpleNamespace(observed={"position": None})]),
        )
    )  # fmt: skip


@pytest.mark.parametrize(("ratio", "told"), [(4.0, True), (4.0, False), (60.0, False)])
def test_near_noise_or_seen_by_a_sensor_it_cannot_be_told(ratio, told):
    assert said(ratio, told).startswith("It cannot be told whether something is missing")


def test_far_above_it_the_model_or_the_driver_is_asked():
    sentence = said(60.0, True)
    assert sentence.startswith("Something is missing, in the model or in what the driver gave")
    assert "more than noise of a sensor" in sentence


@pytest.mark.parametrize(
    ("recording", "told"),
    [(position(1e-5), True), (position(1e-5, 1e-5), False), (position(), False)],
)
def test_an_encoder_whose_step_is_told_does_no_more_than_round(recording, told):
    # Half a step at most is 1.7 times the floor of rounding: no slow noise of it is four times.
    assert ("in what the driver gave" in said(4.0, True, recording)) is told
    assert said(2.5, True, recording).startswith("It cannot be told whether something is missing")
