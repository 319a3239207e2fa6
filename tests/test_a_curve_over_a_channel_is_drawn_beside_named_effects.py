"""What differs from run to run beside a named effect: a curve over its channel in that balance."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.run_levels import RunLevels
from simpter_hybrid.identification.tracing.verdict import Verdict
from simpter_hybrid.identification.unexplained import _where_runs_differ

WAVE = SimpleNamespace(coordinates=("breakaway:position", "force:position"))
NAMED = Verdict("effect", SimpleNamespace(candidate=WAVE))


def levels(share=0.95):
    return (RunLevels("friction", (("a", 0.8), ("b", 1.0), ("c", 1.2)), 9.0, 1.0, share),)


def where(verdict, share=0.95):
    effects = () if verdict.accepted is None else (WAVE,)
    done = SimpleNamespace(verdict=verdict, corrected=SimpleNamespace(effects=effects))
    return _where_runs_differ(done, levels(share))


@pytest.mark.parametrize(
    ("verdict", "told"),
    [
        (Verdict("unknown", coordinates=("friction:run", "friction:speed")), "friction:run"),
        (NAMED, "force:position"),  # the first that is no level of breakaway
        (Verdict("nothing missing"), ""),
    ],
)
def test_it_is_in_the_balance_of_the_verdict_or_of_the_effect(verdict, told):
    assert where(verdict) == told


def test_not_where_own_values_explain_too_little():
    assert where(NAMED, share=0.5) == ""
