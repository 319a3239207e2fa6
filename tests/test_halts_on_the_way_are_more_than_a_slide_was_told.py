"""A slide that sticks and slips halts where its set points go on; turns and stairs are no halts."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import declared_axis

from simpter_hybrid.identification.axis.driven import forgets
from simpter_hybrid.identification.axis.halts import MORE, halts, sticks_and_slips
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.recordings.map_file import RecordingMap
from simpter_hybrid.identification.recordings.recording import RecordedRun, Recording

STEP = 2e-3
TIME = np.arange(0.0, 4.0, STEP)


def stairs(number: int) -> np.ndarray:
    """Each a rest of half its time and a smooth way on of 1 mm."""
    turn = TIME / TIME[-1] * number
    rise = np.clip(2.0 * (turn % 1.0) - 1.0, 0.0, 1.0)
    return 1e-3 * (np.floor(turn) + rise**2 * (3.0 - 2.0 * rise))


@pytest.mark.parametrize("number", [4, 10])
def test_every_halt_between_two_stretches_the_same_way_counts(number):
    # At either end a rest has nothing before it or after it.
    assert halts(stairs(number), STEP, 1e-5) == number - 1


@pytest.mark.parametrize(
    "course", [5e-3 * TIME, 5e-3 * np.sin(12.0 * TIME), np.zeros(TIME.size)]
)  # fmt: skip
def test_a_steady_way_and_turns_are_none(course):
    assert halts(course, STEP, 1e-5) == 0


def test_steps_of_a_coarse_encoder_are_none():
    read = np.round(5e-4 * TIME / 1e-4) * 1e-4  # a count every 0.2 s
    assert halts(read, STEP, 10.0 * 1e-4) <= 1


@pytest.mark.parametrize(
    ("reference", "told"), [(5e-3 * TIME, 0), (stairs(MORE + 1), MORE)], ids=["goes on", "halts"]
)
@pytest.mark.parametrize("number", [MORE, MORE + 1])
def test_so_many_more_than_the_set_points_have_are_sticking_and_slipping(number, reference, told):
    roles = {"position": "measured", "reference": "input"}
    channels = {n: ChannelMap(n, n, "m", role) for n, role in roles.items()}
    noise = 1e-7 * np.random.default_rng(1).standard_normal(TIME.size)
    logged = {"position": stairs(number) + noise, "reference": reference}
    run = RecordedRun("run", "run", "run", (0, TIME.size), TIME, logged)
    recording = Recording("file", RecordingMap("map", channels["position"], channels), (run,))
    slips = number > MORE and told == 0
    assert halts(reference, STEP, 1e-6) == told
    assert sticks_and_slips(recording, "position", "reference") == slips


@pytest.mark.parametrize(
    ("changed", "knows_nothing"),
    [({}, True), ({"integral_gain": 3.0}, False), ({"differenced": 1.0}, False)],
)
def test_an_integral_or_a_differenced_speed_remembers(changed, knows_nothing):
    model = declared_axis()
    ((servo, every),) = model.controllers
    model = replace(model, controllers=((replace(servo, **changed), every),))
    assert forgets(model) == knows_nothing
