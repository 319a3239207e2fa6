"""A sensed torque that is named late and held by the map from row to row: a question."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.held_drives import held_sensor_sentence


def said(effect="force-lag.lag", held="after", name="torque", role="input"):
    lag = SimpleNamespace(
        listed_as=effect.partition(".")[0], parameters=[SimpleNamespace(name=effect)]
    )
    found = SimpleNamespace(search=SimpleNamespace(corrected=SimpleNamespace(effects=(lag,))))
    channels = {name: SimpleNamespace(role=role, held=held)}
    return held_sensor_sentence(found, SimpleNamespace(channels=channels))


@pytest.mark.parametrize("effect", ["force-lag.lag", "force-delay.delay"])
def test_it_is_asked_whether_it_was_read(effect):
    told = said(effect)
    assert told.startswith("The map holds torque from row to row")
    assert effect.partition(".")[0] in told


@pytest.mark.parametrize(
    "other",
    [{"effect": "force-gain.gain"}, {"held": "sampled"}, {"name": "duty"}, {"role": "measured"}],
)
def test_not_of_another_effect_nor_of_what_is_sampled_set_or_compared(other):
    assert said(**other) == ""
