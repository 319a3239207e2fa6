"""All effects together may help runs held out though the last one of them does harm."""

from types import SimpleNamespace

import numpy as np
import pytest
from evidence import trial
from toy_rig import toy_replay

from simpter_hybrid.identification.carried_over import without_harmful
from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting.held_out_sentences import harmful_sentence
from simpter_hybrid.identification.run_levels import RunLevels
from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.round import Round
from simpter_hybrid.identification.tracing.rounds import SearchResult
from simpter_hybrid.identification.tracing.verdict import Verdict

FLOORS = Floors(1.0, 1.0, 1.0)
(HELD_OUT,) = HELD = [toy_replay("held out", 1)]
(SEEN,) = HELD_OUT.observed.values()


def model(select, off, *effects):
    """A model that is off by so many deviations of the runs held out."""
    predicted = {"torque": [SEEN.values + off * SEEN.sd]}
    predictor = SimpleNamespace(predict=lambda values, replays: predicted)
    return SimpleNamespace(
        predictor=predictor, values={}, select_error=select, effects=tuple(effects),
        residuals=np.ones(1),
    )  # fmt: skip


def search(off_by_one, off_by_both, first_kind="effect"):
    """Two effects, of which the second took another tenth off the selecting runs."""
    trials = trial("first", 1.2), trial("second", 1.08)
    first, second = (t.candidate for t in trials)
    bases = [model(1.5, 80.0), model(1.2, off_by_one, first)]
    rounds = tuple(
        Round({}, {}, (t,), Verdict(kind, t), best=t, base=base)
        for t, base, kind in zip(trials, bases, (first_kind, "effect"), strict=True)
    )
    both = model(1.08, off_by_both, first, second)
    return SearchResult(bases[0], both, rounds, Verdict("effect", trials[1]), 1.0)


@pytest.mark.parametrize(("off_by_both", "harms"), [(10.0, True), (3.9, False)])
def test_it_is_taken_back_alone(off_by_both, harms):
    done, harmful = without_harmful(search(4.0, off_by_both), HELD, FLOORS, REPEATED)
    named = [e.name for e in done.corrected.effects]
    assert named == (["first"] if harms else ["first", "second"])
    assert len(done.rounds) == (1 if harms else 2)
    if harms:
        assert done.verdict.kind == "form incomplete"  # 1.2 times the floor is left
        (one,) = harmful
        assert (one.name, one.without, one.with_it) == ("second", pytest.approx(4.0), 10.0)
        said = harmful_sentence(SimpleNamespace(harmful=harmful))
        assert said.startswith("Second lowered the error of the runs that select further")
        assert "with second they have 10, without it 4 times the floor" in said
    else:
        assert harmful == ()
        assert harmful_sentence(SimpleNamespace(harmful=())) == ""


def test_it_is_weighed_against_what_would_be_named_without_it():
    # Without the second the first is not named either, and the refitted model is worse than both.
    asked = search(4.0, 10.0, "open")
    assert without_harmful(asked, HELD, FLOORS, REPEATED) == (asked, ())


def test_runs_with_values_of_their_own_say_nothing_of_it():
    far = [RunLevels("f", (("a", 0.8), ("b", 1.2)), 1.0, 0.1, 0.9)]
    asked = search(4.0, 10.0)
    assert without_harmful(asked, HELD, FLOORS, REPEATED, far) == (asked, ())
