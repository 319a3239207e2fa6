"""How much of a signal curves in other coordinates take away, held out."""

import numpy as np

from simpter_hybrid.identification.tracing.imitation import imitated
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.identification.tracing.trace import Trace


def _trace(seed):
    generator = np.random.default_rng(seed)
    x, z = generator.uniform(0.0, 1.0, (2, 3000))
    along = {"itself": x, "monotone": np.exp(3 * x), "foreign": z}
    return Trace(2.0 * x - 1.0, np.zeros(x.size), along)


def test_a_monotone_function_of_the_coordinate_does_as_well_and_an_independent_one_nothing():
    parts = imitated([_trace(1)], [_trace(2)], ["itself", "monotone", "foreign"])
    # Twelve equal bins leave 1/144 of a uniform variance (quantiles scatter by a few per cent).
    assert abs(parts["itself"] - (1 - 1 / 144)) < 1e-3
    # The same quantiles: the same bins.
    assert abs(parts["monotone"] - parts["itself"]) < 1e-12
    # Twelve means learned from 3000 samples: 12/3000 of the variance lost by chance, on average.
    assert -0.02 < parts["foreign"] < 0.01


def test_an_effect_that_one_offset_does_as_well_asks_nothing():
    first, second = (
        Trace(np.ones(300), np.zeros(300), {"x": np.linspace(0.0, 1.0, 300)}) for _ in range(2)
    )
    assert imitated([first], [second], ["x"]) == {}


def test_an_effect_that_does_nothing_is_not_imitated():
    nothing = Trace(np.zeros(100), np.zeros(100), {"x": np.arange(100.0)})
    assert imitated([nothing], [nothing], ["x"]) == {}


def test_a_balance_whose_channels_were_not_logged_depends_on_nothing():
    silent = Trace(np.zeros(300), np.ones(300), {"x": np.linspace(0.0, 1.0, 300)})
    assert dependences([silent], [silent]) == []
