"""A late speed that is as late beside its position: an effect in its place is excluded."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification import late_by_record
from simpter_hybrid.identification.axis.speed_sensor import FAMILY, LAG
from simpter_hybrid.identification.late_by_record import named_by_record
from simpter_hybrid.identification.tracing.limits import SINGLE
from simpter_hybrid.identification.tracing.round import Round
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.verdict import Verdict

DRIVE = SimpleNamespace(candidate=SimpleNamespace(family="drive timing", name="drive-lag"))


def told(monkeypatch, shown, ratio=1.0, family=FAMILY, summed=False, as_well=()):
    """The verdict where a fitted lag is 12.8 ms, and the record says `shown`."""
    lag = SimpleNamespace(candidate=SimpleNamespace(family=family, name="speed-lag"))
    verdict = Verdict("cannot be told apart", lag, (DRIVE,), (), as_well)
    model = SimpleNamespace(values={LAG: 0.0128}, select_error=ratio)
    done = SearchResult(model, model, (Round({}, {}, (), verdict),), verdict, 1.0)
    monkeypatch.setattr(late_by_record, "behind_position", lambda recording: shown)
    recording = SimpleNamespace(channels={"position": SimpleNamespace(summed=summed)})
    found = named_by_record(done, recording, SINGLE)
    assert found.rounds[0].verdict.rivals == found.verdict.rivals
    return found.verdict


@pytest.mark.parametrize(
    ("ratio", "kind"), [(1.0, "effect"), (2.0 * SINGLE.form, "form incomplete")]
)
def test_where_the_two_agree_it_is_named(monkeypatch, ratio, kind):
    verdict = told(monkeypatch, 0.013, ratio)
    assert (verdict.kind, verdict.rivals) == (kind, ())


@pytest.mark.parametrize(
    "other",
    [{"shown": 0.002}, {"shown": 0.0}, {"shown": 0.02},
     {"shown": 0.013, "summed": True}, {"shown": 0.013, "family": "drive timing"},
     {"shown": 0.013, "as_well": ("force:time",)}],
)  # fmt: skip
def test_else_the_rivals_stay(monkeypatch, other):
    assert told(monkeypatch, **other).rivals == (DRIVE,)
