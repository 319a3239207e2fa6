"""An axis whose spring is unloaded far from where its sensor reads zero."""

import pytest

from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.force_candidates import of_ends
from simpter_hybrid.identification.axis.sizes import AxisSizes


def test_the_rest_is_fitted_from_the_middle_of_the_record_on():
    library = {
        c.name: c
        for c in axis_candidates(AxisSizes(1.0, 2.0, 0.5, 4.0, 0.1, True, low=1.0, high=2.4))
    }
    spring = library["spring-force"]
    names = [p.name for p in spring.parameters]
    assert names == ["spring-force.stiffness", "spring-force.rest"]
    # Where the stiffness is zero its rest shows nothing: fits begin with some of either sign, and
    # with a spring that rests at an end (one that carries a weight).
    assert sorted(s[0] > 0.0 for s in spring.starts if s[1] == 1.7) == [False, True]
    assert [s[1] for s in spring.starts if s[1] != 1.7] == [1.0, 2.4]
    assert spring.contains == ("bias-force",)


def test_a_wheel_that_never_turns_back_has_none():
    sizes = AxisSizes(70.0, 2.0, 200.0, 4.0, 0.1, True, 0.0, 200.0, one_way=True)
    assert not any("spring" in c.name for c in axis_candidates(sizes))


@pytest.mark.parametrize(("end", "bounds"), [("low", (1.0, 2.26)), ("high", (1.14, 2.4))])
def test_one_at_an_end_leaves_a_tenth_of_the_way_free(end, bounds):
    sizes = AxisSizes(1.0, 2.0, 0.5, 4.0, 0.1, False, low=1.0, high=2.4)
    seen = {1.0: (50.0, 1.01), -1.0: (50.0, 2.39)}  # over inertia; where all of the way is met
    (found,) = (c for c in of_ends(sizes, seen) if c.name == f"end-spring-{end}")
    edge = next(p for p in found.parameters if p.name.endswith("edge"))
    assert (edge.lower, edge.upper) == pytest.approx(bounds)
    assert all(edge.lower <= start[1] <= edge.upper for start in found.starts)
