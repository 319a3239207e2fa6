"""Of several guards below zero slip stops come first, then what is switched, then the worst facet.

Both engines ask the same function; here its rule, with two clutches, one effect and three facets.
"""

from types import SimpleNamespace

import pytest

from simpter_hybrid.kernel.rules import first_fallen

MODEL = SimpleNamespace(m=2, ng=1)  # guards: slip 0-1, off 2-3, effect 4, facets 5-7


@pytest.mark.parametrize(
    ("below", "first"),
    [
        ({}, -1),
        ({6: -1e-9, 7: -2e-9}, 7),
        ({4: -1e-15, 7: -1e-9}, 4),
        ({3: -1e-15, 4: -1.0, 5: -1.0}, 3),
        ({1: -1e-300, 3: -1.0, 6: -1.0}, 1),
    ],
)
def test_of_several_guards_below_zero_one_is_acted_on_first(below, first):
    values = [below.get(i, 0.0) for i in range(8)]
    assert first_fallen(MODEL, values, len(values)) == first
