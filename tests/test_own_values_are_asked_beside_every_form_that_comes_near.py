"""Where a parameter differs between runs, a wrong form may fit the common value best."""

from types import SimpleNamespace

from simpter_hybrid.identification import runwise_search

TRIALS = (
    ("stribeck", "velocity", 10.0), ("drag", "drag", 10.5), ("square drag", "drag", 11.0),
    ("warm-up", "wear", 15.0), ("ripple", "wave", 16.0), ("third drag", "drag", 17.0),
    ("bias", "bias", 18.0),
)  # fmt: skip


def _asked(trials, monkeypatch):
    monkeypatch.setattr(runwise_search, "with_effect", lambda model, t, split: t.candidate.name)
    made = [
        SimpleNamespace(candidate=SimpleNamespace(name=n, family=f), select_error=s)
        for n, f, s in trials
    ]
    found = SimpleNamespace(effects=[SimpleNamespace(name="stribeck")])
    done = SimpleNamespace(
        rounds=[SimpleNamespace(trials=made)], corrected=found, refitted="declared"
    )
    return runwise_search._models(SimpleNamespace(search=done, split=None))[1:]


def test_two_forms_of_a_family_and_the_best_of_others(monkeypatch):
    # Near: up to 12.  Far off but the best of four families: warm-up and ripple.
    assert _asked(TRIALS, monkeypatch) == ["drag", "square drag", "warm-up", "ripple"]


def test_no_more_than_four_of_many_near_ones(monkeypatch):
    near = [(f"form {k}", "one", 10.0 + 0.1 * k) for k in range(9)]
    assert _asked(near, monkeypatch) == ["form 0", "form 1", "form 2", "form 3"]
