"""Where one curve leaves far less than all effects that were named, what is missing is unknown."""

from types import SimpleNamespace

import pytest
from asked_curves import concluded, curve

from simpter_hybrid.identification.tracing.verdict import Verdict

REVERSAL, POSITION = "force:displacement_since_reversal", "force:position"


def told(monkeypatch, after, left, along):
    """The verdict on an effect by position that leaves `after`, where a curve leaves `left`."""
    effect = SimpleNamespace(coordinates=(POSITION,))
    models = [
        SimpleNamespace(select_error=s, effects=e, predictor=None, values={})
        for s, e in ((9.0, ()), (after, (effect,)))
    ]
    named = Verdict("effect", SimpleNamespace())
    done = concluded(monkeypatch, named, models, None, along, curve(left))
    return done.verdict.kind, done.verdict.coordinates, bool(done.corrected.effects)


def test_a_curve_along_something_else_outdoes_an_effect(monkeypatch):
    assert told(monkeypatch, 1.4, 1.1, REVERSAL) == ("unknown", (REVERSAL,), False)


@pytest.mark.parametrize(
    ("after", "left", "along"),
    [
        (1.4, 1.2, REVERSAL),  # hardly better
        (1.15, 0.9, REVERSAL),  # what right effects leave
        (1.4, 1.0, POSITION),  # a better form of the same
    ],
)
def test_else_the_effect_stays(monkeypatch, after, left, along):
    assert told(monkeypatch, after, left, along) == ("effect", (), True)


def test_along_its_own_coordinate_a_curve_has_to_leave_half(monkeypatch):
    assert told(monkeypatch, 5.0, 2.0, POSITION) == ("unknown", (POSITION,), False)
