"""A form that bends to two lacks at once does more alone than either; no second one helps it."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest
from toy_rig import ALONG_X, ALONG_Y, ToyRig, tracer

from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.reporting.cautions import passed_over_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED
from simpter_hybrid.identification.tracing.other_way import other_way
from simpter_hybrid.identification.tracing.rounds import before_last, search_effects

#: Goes mostly along x and a little along y, as the lack does; nothing goes together with it.
BENT = Candidate(
    "bent", (Parameter("lean", 0.0, -5.0, 5.0, 0.05),), ((0.1,),), "z", "friction",
    ("friction:x", "friction:y"),
)  # fmt: skip


class BentRig(ToyRig):
    """In which nothing goes together with what is bent."""

    def combines(self, candidate):
        known = {p.name for p in (*self.parameters, *candidate.parameters)}
        return "lean" not in known or known <= {"scale", "lean"}


def run(seed, sizes=(2.0, 0.7), lean=0.12, sd=0.1):
    """A lack along x and y; as it is, 10 times the noise after the refit."""
    time = np.arange(2000) * 0.01
    x, y = np.sin(2.3 * time + seed), np.cos(5.1 * time + 2 * seed)
    ripple = 0.1 * np.cos(11.0 * time)
    inputs = {"u": 1.0 + 0.5 * np.sin(time), "x": x, "y": y, "z": x + lean * y + ripple}
    noise = sd * np.random.default_rng(seed).standard_normal(2000)
    values = inputs["u"] + sizes[0] * x + sizes[1] * y + noise
    seen = Observation(values, sd, np.ones(2000, bool))
    return Replay(f"run {seed}", "abc"[seed % 3], time, inputs, {"torque": seen})


@pytest.fixture(scope="module")
def found():
    split = Split([run(1), run(2)], [run(4), run(5)], [run(7)])
    return search_effects(
        refitted(BentRig(), split), [BENT, ALONG_X, ALONG_Y], split, tracer, floor=1.0
    )


def test_alone_it_does_most(found):
    assert min(found.rounds[0].trials, key=lambda t: t.select_error).candidate is BENT


def test_both_are_named_instead(found):
    assert sorted(e.name for e in found.corrected.effects) == ["along x", "along y"]
    assert found.corrected.select_error == pytest.approx(1.0, abs=0.05)  # 4000 values: 0.011
    assert found.verdict.kind == "effect"
    assert not found.verdict.rivals


def test_the_report_says_what_was_passed_over(found):
    assert [e.name for e in found.passed_over.corrected.effects] == ["bent"]
    said = passed_over_sentence(found)
    assert said.startswith("Begun with bent, which alone leaves less than along x does")
    assert "nothing helped beside it; here it ends at 0.98" in said


def test_it_comes_back_if_the_second_one_is_taken_back(found):
    # Alone the effect that was taken instead leaves more.
    assert before_last(found, REPEATED) is found.passed_over


#: Goes along x for all that is known of it.
ONE_WAY = replace(BENT, coordinates=("friction:x",))


def _search_of_little(*candidates):
    """A lack of half as much again as the noise, of which z leaves next to nothing."""
    runs = [run(k, sizes=(0.4, 0.3), lean=0.3, sd=0.3) for k in (1, 2, 4, 5, 7)]
    split = Split(runs[:2], runs[2:4], runs[4:])
    base = refitted(BentRig(), split)
    return search_effects(base, [ONE_WAY, *candidates], split, tracer, floor=1.0)


def test_near_the_floor_it_is_taken_where_nothing_could_be_named():
    found = _search_of_little(ALONG_X, ALONG_Y)
    assert found.passed_over.verdict.kind == "unknown"
    assert passed_over_sentence(found).startswith("Begun with bent nothing could be named; begun")
    assert found.verdict.kind == "effect"
    assert sorted(e.name for e in found.corrected.effects) == ["along x", "along y"]


def test_what_remains_unknown_remains_so():
    found = _search_of_little(ALONG_X)
    assert found.verdict.kind == "unknown"
    assert found.passed_over is None


def test_a_search_that_has_used_its_effort_up_does_not_begin_anew():
    spent = Effort(most=0.0)
    spent.add(1.0)
    base = SimpleNamespace(predictor=SimpleNamespace(effort=spent))
    first, given = SimpleNamespace(best=1, base=base), SimpleNamespace(floor=1.0)
    ended = SimpleNamespace(select_error=9.0, cost=1.0)
    assert other_way(given, [], [first], ended, unknown=True) is None


def test_nothing_is_said_of_a_search_that_kept_its_way():
    assert passed_over_sentence(SimpleNamespace(passed_over=None)) == ""


def test_one_that_explains_too_little_alone_is_gone_on_with():
    # Two forces of three that nearly cancel: either alone explains a third of what they leave.
    def cancelling(seed):
        replay = run(seed)
        x = replay.inputs["x"]
        inputs = {**replay.inputs, "y": x + 0.7 * replay.inputs["y"]}
        noise = 0.1 * np.random.default_rng(seed).standard_normal(2000)
        values = inputs["u"] + 0.9 * (x - inputs["y"]) + noise
        seen = Observation(values, 0.1, np.ones(2000, bool))
        return replace(replay, inputs=inputs, observed={"torque": seen})

    split = Split([cancelling(1), cancelling(2)], [cancelling(4), cancelling(5)], [cancelling(7)])
    found = search_effects(refitted(BentRig(), split), [ALONG_X, ALONG_Y], split, tracer, floor=1.0)
    assert sorted(e.name for e in found.corrected.effects) == ["along x", "along y"]
    assert found.corrected.values["gain"] == pytest.approx(0.9, abs=0.05)
    assert passed_over_sentence(found) == ""  # nothing had been named
