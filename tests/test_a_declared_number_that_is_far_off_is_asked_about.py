"""A tolerance holds a refit back: a number far beyond it is asked about, whatever it is."""

from types import SimpleNamespace as Some

import pytest
from axis_recordings import declared_axis, recorded_axis

from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.far_off import far_off
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.cautions import far_off_sentence, in_view_of

#: Friction of all takes, over what is declared to a fifth.
TIMES = 2.5


@pytest.fixture(scope="module")
def asked(tmp_path_factory):
    made = recorded_axis(tmp_path_factory.mktemp("axis"), (), friction=(TIMES,) * 3)
    recording = as_recorded(made)
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    split = Split(*(bench.parts[part] for part in ("fit", "select", "report")))
    return refitted(bench.predictor, split), split


def found(asked, kind="unknown", least=1.0, corrected=None):
    model, split = asked
    done = Some(refitted=model, corrected=corrected or model, verdict=Some(kind=kind))
    return far_off(done, split, least)


def test_it_is_told_with_how_far_off_it_is(asked):
    off = found(asked)
    ((name, times),) = off.values
    assert name == "Coulomb friction"
    # Three takes on an encoder know a friction to a thousandth; a hundredth is far more.
    assert times == pytest.approx(TIMES, rel=0.01)
    assert off.left < 0.1
    assert "With Coulomb friction 2.5 times as declared" in far_off_sentence(off)
    assert in_view_of({}, "Nothing is missing.", off=off) == (
        "If the declared numbers are right: nothing is missing."
    )


def test_nobody_asks_where_an_effect_explains_it_or_little_is_left(asked):
    assert found(asked, kind="effect") is None
    assert found(asked, least=1e9) is None
    # Nor where what was found leaves far less.
    assert found(asked, corrected=Some(select_error=1e-3)) is None
