"""Beside a position a late speed is told: where a lack may be that, the verdict says so."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.reporting.late_speed import late_speed_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict


def let_alone(speed_of):
    """A decaying swing in rows of 20 ms, with a speed that is made of its angles."""
    time = 0.02 * np.arange(500)
    angle = np.exp(-0.1 * time) * np.cos(5.0 * time)
    run = SimpleNamespace(time=time[1:], channels={"position": angle[1:], "speed": speed_of(angle)})
    channels = {
        name: ChannelMap(name, name, unit, "measured")
        for name, unit in (("position", "rad"), ("speed", "rad/s"))
    }
    return SimpleNamespace(channels=channels, runs=(run,))


def differences(angle):
    return np.diff(angle) / 0.02


def rates(angle):
    return np.gradient(angle, 0.02)[1:]


@pytest.mark.parametrize(
    ("speed_of", "kind", "said"),
    [(differences, "unknown", True), (differences, "effect", False), (rates, "unknown", False)],
)
def test_of_differences_of_rows_and_of_no_other_speed(speed_of, kind, said):
    sentence = late_speed_sentence(let_alone(speed_of), Verdict(kind))
    assert ("Leave the speed out" in sentence) == said


def test_what_was_named_may_be_that():
    sentence = late_speed_sentence(let_alone(differences), Verdict("effect"), ["drive-lag"])
    assert "(by 10 ms): drive-lag may be that" in sentence  # half a row
    assert not late_speed_sentence(let_alone(rates), Verdict("effect"), ["drive-lag"])
