"""All curves are asked where a refit that went far has bent a residual, or much stays left."""

from dataclasses import dataclass
from types import SimpleNamespace

import pytest

from simpter_hybrid.identification import unexplained
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.tracing.verdict import Verdict

REVERSAL = "force:displacement_since_reversal"


@dataclass(frozen=True)
class Done:
    verdict: Verdict
    declared: SimpleNamespace
    corrected: SimpleNamespace
    floor: float = 1.0


def asked(monkeypatch, mass, where, share, left=1.1):
    """The coordinates told of an unknown lack: of mass to 5 %, and curves over `where`."""
    known = SimpleNamespace(trial=SimpleNamespace(share=share, select=left)) if share else None
    best = SimpleNamespace(trial=SimpleNamespace(select=2.0))
    monkeypatch.setattr(unexplained, "empirical_term", lambda *given: known)
    monkeypatch.setattr(unexplained, "asked_by_curves", lambda *given: ((REVERSAL,), best))
    declared = Parameter("mass", 1.0, 0.5, 1.5, 0.01, tolerance=0.05)
    model = SimpleNamespace(
        select=8.0, values={"mass": mass}, predictor=SimpleNamespace(parameters=(declared,))
    )
    found = SimpleNamespace(
        diagnosis=Done(Verdict("unknown", coordinates=(where,)), model, model), limit=Limits(),
        tracer=lambda *given: {}, split=SimpleNamespace(fit=()),
    )  # fmt: skip
    done, _ = unexplained.with_curve_over_rest(found, (), lambda text: None)
    return done.verdict.coordinates


def test_all_curves_are_asked_after_a_refit_that_went_far(monkeypatch):
    assert asked(monkeypatch, 1.17, "force:acceleration", 0.0) == (REVERSAL,)
    assert asked(monkeypatch, 1.17, "force:acceleration", 0.1) == (REVERSAL,)


@pytest.mark.parametrize(
    ("mass", "where", "share"),
    [
        (1.05, "force:acceleration", 0.0),  # a refit within what is declared
        (1.17, "force:position", 0.6),  # a curve that explains it
        (1.17, "ringing:breakaway", 0.0),  # nothing that a curve could be drawn over
    ],
)
def test_else_what_was_located_stays(monkeypatch, mass, where, share):
    assert asked(monkeypatch, mass, where, share) == (where,)


@pytest.mark.parametrize(("left", "told"), [(4.0, REVERSAL), (2.2, "force:position")])
def test_a_curve_that_leaves_far_less_is_told_in_its_place(monkeypatch, left, told):
    assert asked(monkeypatch, 1.0, "force:position", 0.8, left) == (told,)
