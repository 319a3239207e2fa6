"""What is left is called noise where runs held out and the size of a dependence agree."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.dependence_text import hardly_left_text
from simpter_hybrid.identification.tracing.limits import REPEATED, known_by_repetition


def found(part):
    """A diagnosis whose last effect leaves a dependence of such a part of the mean square."""
    seen = {"force": [SimpleNamespace(coordinate="acceleration", gain=part)]}
    last = SimpleNamespace(after=seen, verdict=SimpleNamespace(accepted=object()))
    verdict = SimpleNamespace(coordinates=("force:acceleration",))
    # The repeated runs differ by 8.9 times the noise: half more of it is still within the limit.
    limits = known_by_repetition(REPEATED, 8.9, 0.2)
    search = SimpleNamespace(rounds=(last,), verdict=verdict)
    return SimpleNamespace(search=search, limits=limits)


def test_a_little_beside_noise_is_called_so():
    said = hardly_left_text(found(0.012), "acceleration", 1.05)
    assert said == (
        " What is left is noise but for a little (1.2 % of its mean square) that goes along with "
        "acceleration."
    )


@pytest.mark.parametrize(("part", "held"), [(0.012, 1.492), (0.294, 1.492)])
def test_else_it_is_said_to_depend_plainly(part, held):
    said = hardly_left_text(found(part), "acceleration", held)
    assert said == (
        f" What is left depends on acceleration ({100 * part:.1f} % of its mean square)."
    )


def test_more_than_a_little_of_what_is_as_large_as_noise_is_told_as_both():
    said = hardly_left_text(found(0.19), "speed", 1.0)
    assert said == (
        " What is left is as large as noise, but goes along with speed (19.0 % of its mean square)."
    )
