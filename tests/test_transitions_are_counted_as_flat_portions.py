"""The thesis counts the flat portions of slip velocity; turning round at once is a reversal."""

from sampled_runs import FORCE, START, baseline, oscillator, swings

from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.measuring.transitions import transitions


def test_a_coulomb_oscillator_turns_round_until_it_rests():
    counted = transitions(oscillator())
    half_swings = len(swings(oscillator().scenario.device, FORCE, START))
    assert counted.reversals == (half_swings - 1,)
    assert counted.counts == (1,)
    assert counted.flat[0][0][1] == oscillator().t_end


def test_flat_portions_are_those_seen_in_samples():
    run = baseline()
    counted = transitions(run)
    s = sample(run)
    for i in range(4):
        flat = s.slip[:, i] == 0.0
        # The run starts at rest and leaves it at once: no portion, for it takes no time.
        assert flat[0]
        assert not flat[1]
        starts = flat[2:-1] & ~flat[1:-2] & flat[3:]
        assert counted.counts[i] == starts.sum()
    assert counted.total == sum(counted.counts) > 0
