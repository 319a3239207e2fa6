"""Where one curve leaves far less than all effects that were named, what is missing is unknown."""

from dataclasses import dataclass
from types import SimpleNamespace

import pytest

from simpter_hybrid.identification import unexplained
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.tracing.verdict import Verdict

REVERSAL, POSITION = "force:displacement_since_reversal", "force:position"


@dataclass(frozen=True)
class Done:
    verdict: Verdict
    declared: SimpleNamespace
    corrected: SimpleNamespace
    floor: float = 1.0


def told(monkeypatch, after, curve, along):
    """The verdict on an effect by position that leaves `after`, where a curve leaves `curve`."""
    term = SimpleNamespace(trial=SimpleNamespace(select=curve, share=0.9))
    monkeypatch.setattr(unexplained, "empirical_term", lambda *given: None)
    monkeypatch.setattr(unexplained, "asked_by_curves", lambda *given: ((along,), term))
    effect = SimpleNamespace(coordinates=(POSITION,))
    models = (
        SimpleNamespace(select=s, effects=e, predictor=None, values={})
        for s, e in ((9.0, ()), (after, (effect,)))
    )
    found = SimpleNamespace(
        diagnosis=Done(Verdict("effect", SimpleNamespace()), *models), limit=Limits(),
        tracer=lambda *given: {}, split=SimpleNamespace(fit=()),
    )  # fmt: skip
    done, _ = unexplained.with_curve_over_rest(found, (), lambda text: None)
    return done.verdict.kind, done.verdict.coordinates, bool(done.corrected.effects)


def test_a_curve_along_something_else_outdoes_an_effect(monkeypatch):
    assert told(monkeypatch, 1.4, 1.1, REVERSAL) == ("unknown", (REVERSAL,), False)


@pytest.mark.parametrize(
    ("after", "curve", "along"),
    [
        (1.4, 1.2, REVERSAL),  # hardly better
        (1.15, 0.9, REVERSAL),  # what right effects leave
        (1.4, 1.0, POSITION),  # a better form of the same
    ],
)
def test_else_the_effect_stays(monkeypatch, after, curve, along):
    assert told(monkeypatch, after, curve, along) == ("effect", (), True)


def test_along_its_own_coordinate_a_curve_has_to_leave_half(monkeypatch):
    assert told(monkeypatch, 5.0, 2.0, POSITION) == ("unknown", (POSITION,), False)
