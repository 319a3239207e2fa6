"""An effect that comes nearest on the runs that select may be contradicted by those held out."""

from types import SimpleNamespace as Some

from simpter_hybrid.identification.held_out_gains import HeldOutGain
from simpter_hybrid.identification.reporting.nearest import nearest_text


def _said(*intervals):
    """Of a round for each interval of what its best effect takes away on the runs held out."""
    rounds, gains = [], []
    for name, interval in zip("ab", intervals, strict=False):
        best = Some(candidate=Some(name=name), gain=0.43)
        rounds.append(Some(best=best, verdict=Some(accepted=best)))
        gains.append((HeldOutGain("other", -0.9, -1.0, -0.8), HeldOutGain(name, *interval)))
    return nearest_text(Some(search=Some(rounds=rounds), gains=gains))


WORSE, UNSURE = (-0.16, -0.51, -0.1), (-0.16, -0.51, 0.1)


def test_by_how_much_where_its_interval_lies_below_zero():
    assert _said(WORSE) == (
        " (a, which comes nearest, takes 43 % of the error of the runs that select away, but makes "
        "that of the runs held out 16 % larger)"
    )


def test_not_where_it_may_help():
    assert "but" not in _said(UNSURE)
    assert "but" not in _said((-0.16, float("-inf"), float("inf")))


def test_of_several_the_one_that_does_is_named():
    assert _said(UNSURE, WORSE).endswith("away, but b makes that of the runs held out 16 % larger)")


def test_nothing_where_they_were_not_asked():
    best = Some(candidate=Some(name="a"), gain=0.43)
    found = Some(search=Some(rounds=[Some(best=best)]), gains=())
    assert nearest_text(found).endswith("select away)")
