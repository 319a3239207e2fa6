"""Far above the floor two curves may explain alike; at it one that leaves half more does not."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification import unexplained


@pytest.mark.parametrize(
    ("left", "told"),
    [
        ((1.02, 1.62, 1.1), ("force:reversal", "force:speed")),
        ((1.02, 1.15, 3.0), ("force:reversal", "force:position")),
    ],
)
def test_what_is_told(monkeypatch, left, told):
    names = ("reversal", "position", "speed")
    terms = {f"force:{name}": SimpleNamespace(name=name) for name in names}
    trials = [
        SimpleNamespace(candidate=terms[f"force:{name}"], select_error=select, gain=0.5,
                        share=(3.0**2 - select**2) / (3.0**2 - 1.0))
        for name, select in zip(names, left, strict=True)
    ]  # fmt: skip
    monkeypatch.setattr(unexplained, "terms_over", lambda along, traces: (terms[along],))
    monkeypatch.setattr(unexplained, "pieces_of", lambda along, traces: ())
    monkeypatch.setattr(unexplained, "best_probes", lambda *given: [])
    monkeypatch.setattr(unexplained, "try_candidates", lambda *given, **more: trials)
    monkeypatch.setattr(unexplained, "curve_of", lambda best, *given: best)
    traces = {"force": [SimpleNamespace(coordinates=dict.fromkeys(names))]}
    where, term = unexplained.asked_by_curves(None, traces, SimpleNamespace(fit=()), 1.0)
    assert where == told
    assert term is trials[0]
