"""Places of a slide are no angles, though they are between 0 and 2 pi; what turns is folded."""

import numpy as np
import pytest

from simpter_hybrid.effects.empirical_friction import EmpiricalByAngle, EmpiricalByPosition
from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.trace import Trace


@pytest.mark.parametrize(
    ("places", "kind"),
    [
        (np.linspace(0.0, 0.5, 500), EmpiricalByPosition),
        (np.linspace(1.0, 4.0, 500), EmpiricalByPosition),
        (np.linspace(-1.0, 20.0, 500), EmpiricalByPosition),
        (np.mod(np.linspace(-1.0, 20.0, 500), 2 * np.pi), EmpiricalByAngle),
    ],
)
def test_over_what(places, kind):
    trace = Trace(np.ones(places.size), np.ones(places.size), {"position": places})
    effects = [term.effect for term in terms_over("force:position", {"force": [trace]})]
    over = [e for e in effects if isinstance(e, EmpiricalByAngle | EmpiricalByPosition)]
    assert [type(e) for e in over] == [kind]
    if kind is EmpiricalByPosition:
        # All but a few thousandths of the places at either end.
        ends = pytest.approx((places.min(), places.max()), abs=0.005 * np.ptp(places))
        assert (over[0].low, over[0].high) == ends
