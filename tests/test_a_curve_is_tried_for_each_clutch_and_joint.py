"""Of curves one of a name is tried, so a name says the clutch or joint and both ends."""

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.trace import Trace

RNG = np.random.default_rng(0)
N = 2000


def trace(**along):
    return Trace(RNG.normal(size=N), RNG.normal(size=N), along)


@pytest.fixture(scope="module")
def two_joints():
    """Two joints that move alike, with two clutches on the first."""
    speed, place = RNG.normal(size=N), RNG.uniform(-1.0, 1.0, N)
    slips = {"slip_1": np.sign(speed), "slip_2": -np.sign(speed)}
    pressed = {f"excitation_{k}": np.linspace(0.0, 8.0, N) for k in (1, 2)}
    first = trace(slip_velocity=speed, position=place, **slips, **pressed)
    return {"joint_1": [first], "joint_2": [trace(position=place)]}


@pytest.mark.parametrize(
    ("coordinates", "which"),
    [
        (("joint_1:slip_1", "joint_1:slip_2"), "clutch"),
        (("joint_1:excitation_1", "joint_1:excitation_2"), "clutch"),
        (("joint_1:position", "joint_2:position"), "coordinate"),
    ],
)
def test_places_have_curves_of_their_own(two_joints, coordinates, which):
    found = {t.name: t for c in coordinates for t in terms_over(c, two_joints)}
    assert {getattr(t.effect, which) for t in found.values()} == {0, 1}


def test_a_curve_where_most_samples_lie_is_another_one():
    usual = np.concatenate([RNG.uniform(0.2, 1.0, N // 10), RNG.uniform(0.93, 1.0, N - N // 10)])
    terms = terms_over("force:speed", {"force": [trace(speed=usual)]})
    names = [t.name for t in terms]
    assert len(names) == len(set(names))
