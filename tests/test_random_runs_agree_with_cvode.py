"""Random runs against SUNDIALS CVODE with root finding, under an automaton coded apart."""

import pytest
from random_runs import KINDS, random_run
from same_events import assert_agree, first_difference, story, story_of

from simpter_hybrid.engine import simulate

pytest.importorskip("sksundae", reason="needs scikit-sundae (pip install scikit-sundae)")
#: CVODE at rtol 1e-12 ends 3e-10 from heyoka's Taylor series; a flat guard makes more of it [s].
FLAT = 1e-8


def compare(kind, seed):
    from cvode_engine import Automaton

    run = random_run(kind, seed)
    found, other = simulate(run), Automaton(run).run()
    assert_agree(found, other, FLAT, 1e-8, (kind, seed))


@pytest.mark.parametrize("kind", KINDS)
def test_the_reference_engine(kind):
    compare(kind, 1)


# Without the controllers: there CVODE refuses short stretches between sample instants and events
# ("output and initial times are too close"), and in one run (controller 30 Hz, seed 2) it finds a
# breakaway 42 ms late, on which Taylor series side with the engine.
@pytest.mark.slow
@pytest.mark.parametrize("kind", [k for k in KINDS if not k.startswith("controller")])
def test_twenty(kind):
    for seed in range(2, 22):
        compare(kind, seed)


def test_without_a_bound_on_its_step_it_misses_events_and_we_do_not():
    # A locked set has a trivial derivative, so that steps grow past a whole breakaway and back.
    from cvode_engine import Automaton

    run = random_run("constant", 12)
    told = [
        story((t, after) for t, _, _, after in Automaton(run, max_step=step).run().events)
        for step in (5e-3, 0.0)
    ]
    found = story_of(simulate(run))
    assert not first_difference(found, told[0], FLAT)
    assert first_difference(found, told[1], FLAT)
