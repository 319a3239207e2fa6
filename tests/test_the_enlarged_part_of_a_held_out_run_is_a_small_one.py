"""What is drawn beside the whole run shows much less of it, or is not drawn."""

import pytest

from simpter_hybrid.plots.held_out import enlarged


@pytest.mark.parametrize("samples", [300, 1600, 100_000])
@pytest.mark.parametrize("place", [0.0, 0.5, 0.999])
def test_it_holds_its_centre_and_at_most_a_fifth_of_the_run(samples, place):
    centre = int(place * samples)
    part = enlarged(samples, centre)
    assert part is not None
    assert 0 <= part.start <= centre < part.stop <= samples
    assert 50 <= part.stop - part.start <= samples / 5


def test_of_a_short_run_nothing_is_enlarged():
    assert enlarged(200, 100) is None
