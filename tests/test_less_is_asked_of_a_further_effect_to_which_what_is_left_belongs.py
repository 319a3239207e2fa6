"""Where the first effect leaves a dependence on the second's own coordinate, 2 % are enough."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.tracing.limits import REPEATED, SINGLE_AXIS
from simpter_hybrid.identification.tracing.rivals import LEAST_FURTHER, LEAST_GAIN
from simpter_hybrid.identification.tracing.round import _asked_of
from simpter_hybrid.identification.tracing.signature import Dependence


def _asked(
    limit=REPEATED, left=1.12, share=0.46, own="friction:slip_velocity", first=("pull-in",),
    gain=0.047, least=0.0,
):  # fmt: skip
    """Asked of a trial, where 6 % of what is left go along with the slip, 4 % with the drive."""
    seen = tuple(
        Dependence(name, gain, 0.005, 1000, *(3 * [[0.0]]))
        for name, gain in (("slip_velocity", 0.063), ("drive", 0.04))
    )
    candidate = SimpleNamespace(
        name="stribeck", family="velocity", coordinates=(own,), contains=(), declared=False,
        yields_to="", parameters=("rise", "fade"), least=least,
    )  # fmt: skip
    trial = SimpleNamespace(candidate=candidate, share=share, gain=gain, select_error=1.07)
    given = SimpleNamespace(limit=limit, floor=1.0)
    base = SimpleNamespace(select_error=left, effects=first)
    return _asked_of(given, base, SimpleNamespace(dependences={"friction": seen}), [trial])


def test_its_own_coordinate_leads():
    assert _asked() == LEAST_GAIN


@pytest.mark.parametrize(
    "but",
    [
        {"own": "friction:drive"},  # which goes along with less
        {"own": "friction:heat"},
        {"share": 0.3},  # a patch of an imperfect form takes little of what it leaves
        {"gain": 0.015},
        {"least": 0.05},  # a wave, the best of hundreds: no other is to come in by it
        {"left": 1.04},  # at the floor nothing is left
        {"limit": SINGLE_AXIS},  # a floor that nobody repeated a run for
    ],
)
def test_else_as_much_is_asked_as_of_any_further_one(but):
    assert _asked(**but) == LEAST_FURTHER


def test_of_a_first_effect_nothing_changes():
    assert _asked(first=()) == LEAST_GAIN
