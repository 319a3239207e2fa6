"""A finished search whose curves are given, not fitted: what is concluded from them is asked."""

from dataclasses import dataclass
from types import SimpleNamespace

from simpter_hybrid.identification import unexplained
from simpter_hybrid.identification.tracing.limits import Limits
from simpter_hybrid.identification.tracing.verdict import Verdict


@dataclass(frozen=True)
class Done:
    """What a diagnosis has."""

    verdict: Verdict
    refitted: SimpleNamespace
    corrected: SimpleNamespace
    floor: float = 1.0


def curve(select, share=0.9):
    """A curve that leaves so much of the selecting runs."""
    return SimpleNamespace(trial=SimpleNamespace(select_error=select, share=share))


def concluded(monkeypatch, verdict, models, known, along, best):
    """The diagnosis after curves: `known` over what was located, `best` of all, over `along`."""
    monkeypatch.setattr(unexplained, "empirical_term", lambda *given: known)
    monkeypatch.setattr(unexplained, "asked_by_curves", lambda *given: ((along,), best))
    found = SimpleNamespace(
        search=Done(verdict, *models), limit=Limits(),
        tracer=lambda *given: {}, split=SimpleNamespace(fit=()),
    )  # fmt: skip
    return unexplained.with_curve_over_rest(found, (), lambda text: None)[0]
