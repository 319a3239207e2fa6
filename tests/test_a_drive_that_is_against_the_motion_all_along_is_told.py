import numpy as np
import pytest

from simpter_hybrid.identification.axis.opposed import opposed
from simpter_hybrid.identification.fitting.replay import Replay

TIME = 0.01 * np.arange(1000)


def run(drive: np.ndarray, speed: np.ndarray) -> Replay:
    return Replay("r", "r", TIME, {"drive": drive}, {}, notes={"speed": speed})


def test_a_drive_with_the_wrong_sign_is_told() -> None:
    pulses = np.where(np.sin(TIME) > -0.5, 12.0, 0.0)
    (told,) = opposed([run(pulses, -pulses)], 0.05)
    assert told.value == "100 %"
    assert "sign of one of them is wrong in the map" in told.right


@pytest.mark.parametrize("lag", [0.0, 0.7], ids=["with it", "late"])
def test_a_drive_that_moves_it_is_not(lag: float) -> None:
    assert opposed([run(np.sin(TIME), np.sin(TIME - lag))], 0.05) == ()


def test_nor_one_that_is_negative_by_the_model() -> None:
    assert opposed([run(np.sin(TIME), -np.sin(TIME))], -0.05) == ()


def test_nor_where_nothing_drives() -> None:
    assert opposed([run(0.0 * TIME, np.exp(-TIME))], 0.05) == ()
