"""Where no more than noise is left, a reader wants to know how little goes along with what."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.dependence_text import hardly_left_text
from simpter_hybrid.identification.tracing.limits import SINGLE


def found(named):
    """A diagnosis whose last round saw parts of a mean square with and without its best."""
    seen = [SimpleNamespace(coordinate=c, gain=g) for c, g in (("time", 0.012), ("drive", 0.004))]
    other = [SimpleNamespace(coordinate="time", gain=0.3)]
    last = SimpleNamespace(
        after={"friction": seen if named else other},
        before={"friction": other if named else seen},
        verdict=SimpleNamespace(accepted=object() if named else None),
    )
    verdict = SimpleNamespace(coordinates=("friction:time", "friction:drive"))
    search = SimpleNamespace(rounds=(last,), verdict=verdict)
    return SimpleNamespace(search=search, limits=SINGLE)


@pytest.mark.parametrize("named", [True, False])
def test_the_largest_part_is_told(named):
    text = hardly_left_text(found(named), "time and drive", 1.0)
    assert text.endswith("a little (1.2 % of its mean square) that goes along with time and drive.")


def test_no_part_is_told_of_what_no_table_holds():
    one = found(True)
    one.search.verdict.coordinates = ("friction:run",)
    text = hardly_left_text(one, "the run", 1.0)
    assert text.endswith("a little that goes along with the run.")
