"""Four stuck clutches, a growing push: which of them let go together, and what they lacked."""

import pytest
from sampled_runs import TORQUES, locked

from simpter_hybrid.devices import pter_reduced
from simpter_hybrid.explanation.explain import explain
from simpter_hybrid.measuring.sampling import sample


def breakaway(run):
    return next(event for event in run.events if event.kind == "breakaway")


@pytest.mark.parametrize("ratio", [1.0, 1.2])
def test_the_facet_is_named_with_needed_and_available_torque(ratio):
    run = locked(ratio)
    event = breakaway(run)
    e = explain(run, event.t)
    facet = e.facets[0]
    assert event.case_before == "7.5"
    released = tuple(i + 1 for i, share in enumerate(facet.pattern) if share > 0.0)
    assert released == (1, 2, 3)
    # Half of clutches 1 and 2, all of clutch 3: the facet b3 + (b1 + b2)/2 of Case 7.5.
    limit = ratio * (TORQUES[2] + 0.5 * (TORQUES[0] + TORQUES[1]))
    assert facet.available == pytest.approx(limit, rel=1e-12)
    # A breakaway is located to rounding of the torques, some 10 N m.
    assert facet.margin == pytest.approx(0.0, abs=1e-9)
    assert "1 forward, 2 backward, 3 forward" in str(e)


def test_margins_agree_with_the_derived_equations():
    run = locked()
    t = 0.5 * breakaway(run).t
    s = sample(run, [t])
    g = [float(v) for v in s.load[0]]
    brk = [float(v) for v in s.tau_break[0]]
    p = run.scenario.parameter_values()
    derived = pter_reduced.margin_15(s.q[0].tolist(), s.qd[0].tolist(), g, brk, p)
    assert s.margin[0] == pytest.approx(derived, rel=1e-12)
    assert min(facet.margin for facet in explain(run, t).now) == pytest.approx(derived, rel=1e-12)


def test_redundant_sharing_is_called_a_convention():
    run = locked()
    e = explain(run, breakaway(run).t)
    assert e.redundant == (1, 2, 3, 4)
    assert "convention" in str(e)
