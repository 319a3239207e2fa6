"""A drive that is held and changes at most rows may change between them: then no effect helps."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.reporting.cautions import between_rows_sentence
from simpter_hybrid.identification.tracing.verdict import Verdict


def recording(values, held="after", role="input", name="duty"):
    run = SimpleNamespace(channels={name: np.asarray(values)})
    return SimpleNamespace(
        runs=[run, SimpleNamespace(channels={})],
        channels={name: SimpleNamespace(role=role, held=held)},
    )


SERVO, LEVELS = np.tile([0.0, 1.0], 50), np.repeat([0.0, 1.0], 50)
RAMP, WAVE = np.arange(101.0), np.sin(0.1 * np.arange(101.0))
NOTHING = Verdict("unknown")


def test_a_wave_of_few_rows_is_named():
    # Of a wave of 6.3 rows the turning points alone go on nearly as they did.
    assert "(duty at 86 %)" in between_rows_sentence(recording(np.sin(np.arange(101.0))), NOTHING)


def test_what_changes_at_every_row_is_named_with_how_often():
    assert "(duty at 100 %)" in between_rows_sentence(recording(SERVO), NOTHING)


@pytest.mark.parametrize(
    ("made", "verdict"),
    [
        (recording(LEVELS), NOTHING),
        (recording(RAMP), NOTHING),
        (recording(WAVE), NOTHING),
        (recording(SERVO, held="sampled"), NOTHING),
        (recording(SERVO, role="measured"), NOTHING),
        (recording(SERVO, name="command_2"), NOTHING),
        (recording(SERVO), Verdict("form incomplete")),
    ],
)
def test_levels_courses_sensors_and_commands_hide_nothing_nor_does_what_an_effect_explains(
    made, verdict
):
    assert between_rows_sentence(made, verdict) == ""
