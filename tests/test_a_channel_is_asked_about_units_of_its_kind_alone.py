from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.channel_factors import factors_of_quantity
from simpter_hybrid.identification.map_changes import unit_instead

DEG, RPM = np.pi / 180, np.pi / 30


@pytest.mark.parametrize(
    ("signal", "unit", "size", "asked"),
    [
        ("speed", "km/h", 1 / 3.6, {"metres a second, not kilometres an hour"}),
        ("speed", "m/s", 1.0, {"kilometres an hour, not metres a second"}),
        ("position", "deg", DEG, {"radians, not degrees", "turns, not degrees"}),
        ("position", "mm", 1e-3, set()),
        (
            "speed", "deg/s", DEG,
            {"radians, not degrees", "turns, not degrees", "turns a minute, not degrees a second"},
        ),
        (
            "speed", "rpm", RPM,
            {
                "radians a second, not turns a minute", "degrees a second, not turns a minute",
                "turns a second, not turns a minute",
            },
        ),
    ],
)  # fmt: skip
def test_a_channel_is_asked_about_units_of_its_kind_alone(signal, unit, size, asked):
    channels = {signal: SimpleNamespace(unit=unit, unit_scale=size, summed=False)}
    factors = factors_of_quantity(SimpleNamespace(channels=channels, runs=[]), (signal,))
    assert {said for f in factors if (said := unit_instead(f))} == asked
