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


def turning(wave):
    """Four runs that turn to and fro, with a speed that is 20 ms late and a wave in the angle."""
    one, time = let_alone(differences), 0.02 * np.arange(500)
    runs = []
    for k in range(4):
        rate = 0.6 + 0.2 * k
        angle = 4.0 * np.sin(rate * time) + 0.8 * np.sin(6.0 * time) + k
        speed = 4.0 * rate * np.cos(rate * (time - 0.02)) + 4.8 * np.cos(6.0 * (time - 0.02))
        shown = angle + wave * np.sin(angle)
        runs.append(SimpleNamespace(time=time, channels={"position": shown, "speed": speed}))
    return SimpleNamespace(channels=one.channels, runs=runs)


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


@pytest.mark.parametrize("wave", [0.0, 0.02])
def test_it_stays_in_the_map_while_it_alone_tells_that_an_encoder_is_off_its_axis(wave):
    sentence = late_speed_sentence(turning(wave), Verdict("unknown"))
    assert "is behind the position" in sentence
    assert sentence.endswith("Then leave the speed out.") == (wave > 0.0)
