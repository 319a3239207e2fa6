"""Runs held out choose nothing; where they would choose otherwise, a reader is told."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.held_out_gains import HeldOutGain
from simpter_hybrid.identification.reporting.not_shown import outdone_sentence


def candidate(name, family="", contains=(), declared=False):
    family = family or name
    return SimpleNamespace(name=name, family=family, contains=contains, declared=declared)


NAMED, FIRST = candidate("asymmetry", contains=("settling",)), candidate("drag")
DECLARED = candidate("settling", declared=True)


def found(before=(), effects=(NAMED,), after=1.5, other=None):
    """A search that ended with a round which named the asymmetry, on a base of effects."""
    other = other or DECLARED  # the named effect contains it, and yet leaves more
    trials = [SimpleNamespace(candidate=c) for c in (NAMED, other)]
    verdict = SimpleNamespace(accepted=SimpleNamespace(candidate=NAMED))
    base = SimpleNamespace(effects=before)
    rounds = [SimpleNamespace(verdict=verdict, base=base, trials=trials)]
    search = SimpleNamespace(corrected=SimpleNamespace(effects=effects), rounds=rounds)
    floors = Floors(1.0, 1.0, 1.0)
    return SimpleNamespace(search=search, floors=floors, error_by_stage={"after": after})


def gains(beyond, surely):
    other = HeldOutGain("settling", 0.5, 0.4, 0.6, beyond=beyond, surely_beyond=surely)
    return [[HeldOutGain("asymmetry", 0.4, 0.3, 0.5), other]]


def test_the_better_one_is_told():
    told = outdone_sentence(found(), gains(0.13, 0.05))
    assert "others leave less than asymmetry (settling 13 % less)" in told


@pytest.mark.parametrize(
    ("shown", "beyond", "surely"),
    [
        (found(), 0.13, -0.01),  # not surely
        (found(), 0.03, 0.01),  # hardly
        (found(after=1.0), 0.13, 0.05),  # what was named leaves noise alone
        (found(effects=(FIRST, NAMED)), 0.13, 0.05),  # the other effect was not there
        (found(effects=()), 0.13, 0.05),
        (found(other=candidate("settling", "asymmetry")), 0.13, 0.05),  # another form of it
        (found(other=candidate("settling")), 0.13, 0.05),  # a simpler one
        (found(other=candidate("settling", contains=("asymmetry",))), 0.13, 0.05),
    ],
)
def test_nothing_is_told_where_that_says_little(shown, beyond, surely):
    assert outdone_sentence(shown, gains(beyond, surely)) == ""


def test_of_two_effects_the_last_round_is_asked():
    two = found(before=(FIRST,), effects=(FIRST, NAMED))
    assert "settling" in outdone_sentence(two, gains(0.13, 0.05))
