"""Plays with lift against the closed form of a first rise and of a fall from the top."""

import pytest

from simpter_hybrid.effects.play_hysteresis import PlayHysteresis

SHARE, WIDTH = 0.4, 0.9
WIDTHS = (WIDTH / 3.0, WIDTH / 1.5, WIDTH)


def _effective(excitation, memories, lift):
    return PlayHysteresis.effective_excitation(excitation, *memories, SHARE, WIDTH, lift)


@pytest.mark.parametrize("excitation", [0.1, 0.5, 2.0, 7.0])
def test_at_lift_1_the_first_rise_from_zero_is_the_declared_map(excitation):
    memories = [max(0.0, excitation - w) for w in WIDTHS]
    assert _effective(excitation, memories, 1.0) == pytest.approx(excitation, abs=1e-14)


def test_a_fall_from_the_top_lies_above_by_the_share_of_twice_the_mean_width():
    top, excitation = 8.0, 4.0  # farther below the top than twice the widest play
    memories = [min(top - w, excitation + w) for w in WIDTHS]
    wider = 2.0 * SHARE * sum(WIDTHS) / 3.0
    assert _effective(excitation, memories, 1.0) == pytest.approx(excitation + wider, rel=1e-14)


def test_without_lift_the_loop_lies_about_the_declared_map():
    rising = _effective(4.0, [4.0 - w for w in WIDTHS], 0.0)
    falling = _effective(4.0, [4.0 + w for w in WIDTHS], 0.0)
    assert rising + falling == pytest.approx(8.0, rel=1e-14)
    assert falling > rising
