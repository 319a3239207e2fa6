"""Events are shuffled, not turned in phase: a regular test does not hide what they depend on."""

from dataclasses import replace

import numpy as np

from simpter_hybrid.identification.tracing.locating import located
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.identification.tracing.trace import Trace


def _levels(lower: float, seed: int, scatter: float = 0.01) -> Trace:
    """Fourteen breakaways as on a testbed: six to and fro, eight the same way."""
    generator = np.random.default_rng(seed)
    way = np.array([0.5, 0, 0, 0, 0, 0, 0.5, 1, 1, 1, 1, 1, 1, 1])
    error = scatter * generator.standard_normal(way.size) - lower * (way == 1.0)
    along = {"same_way": way, "rest": np.log10(generator.permutation(np.linspace(0.3, 5, 14)))}
    return Trace(error, np.zeros(way.size), along, events=True)


def test_a_regular_difference_is_found():
    (best, other) = dependences([_levels(0.05, 1)], [_levels(0.05, 2)])
    assert best.coordinate == "same_way"
    assert best.p_value <= 0.01
    assert other.p_value > 0.01  # what a verdict asks for


def test_scatter_alone_is_rarely_called_a_dependence():
    found = [dependences([_levels(0.0, k)], [_levels(0.0, 1000 + k)]) for k in range(100)]
    # Expected 1 of 100 at this level, over all coordinates together; 5 has a chance of 0.4 %.
    assert sum(min(d.p_value for d in some) <= 0.01 for some in found) <= 4


def test_a_coordinate_of_two_values_has_two_bins():
    way = np.repeat([-1.0, 1.0], 60)
    trace = Trace(0.3 * way, np.zeros(way.size), {"direction": way})
    (found,) = dependences([trace], [trace])
    assert np.allclose(found.added, [-0.3, 0.3])


def test_what_scatter_may_teach_of_levels_is_no_dependence():
    def found(lower):
        learned, tested = ([_levels(lower, k, 0.003)] for k in (1, 2))
        some = dependences(learned, tested)
        assert min(d.p_value for d in some) <= 0.01
        return located([replace(d, coordinate=f"breakaway:{d.coordinate}") for d in some])

    assert found(0.05) == ("breakaway:same_way",)
    # Half of the events lower by 2 %: significant, and a standard deviation of 1 %.
    assert found(0.02) == ()
