"""Far above the floor a name stands beside a curve along what is left that does about as well."""

from types import SimpleNamespace

import pytest
from asked_curves import concluded, curve

from simpter_hybrid.identification.tracing.verdict import Verdict

REVERSAL, SLIP = "force:displacement_since_reversal", "force:slip_velocity"


def told(monkeypatch, after, left, along=REVERSAL, depends=(REVERSAL,)):
    """The verdict on an effect by speed that leaves `after` of 130, where a curve leaves `left`."""
    effect = SimpleNamespace(coordinates=(SLIP,))
    predictor = SimpleNamespace(parameters=())
    models = [
        SimpleNamespace(select_error=s, effects=e, predictor=predictor, values={})
        for s, e in ((130.0, ()), (after, (effect,)))
    ]
    named = Verdict("form incomplete", SimpleNamespace(), (), depends)
    done = concluded(monkeypatch, named, models, None, along, curve(left))
    assert done.corrected.effects  # it is still added
    return done.verdict.kind, done.verdict.as_well


def test_a_foreign_curve_that_does_about_as_well(monkeypatch):
    assert told(monkeypatch, 33.0, 37.0) == ("cannot be told apart", (REVERSAL,))


@pytest.mark.parametrize(
    ("after", "left", "along", "depends"),
    [
        (33.0, 41.0, REVERSAL, (REVERSAL,)),  # clearly worse
        (2.5, 2.6, REVERSAL, (REVERSAL,)),  # not far above the floor
        (33.0, 30.0, SLIP, (SLIP,)),  # a better form of the same
        (33.0, 37.0, REVERSAL, (SLIP,)),  # nothing of it is left
    ],
)
def test_else_the_form_is_incomplete(monkeypatch, after, left, along, depends):
    assert told(monkeypatch, after, left, along, depends) == ("form incomplete", ())
