"""A guard that has fallen by rounding alone is an event, whatever the interpolant says of it."""

from types import SimpleNamespace

from simpter_hybrid.running.kept_guards import KeptGuards


def test_a_guard_at_the_end_of_a_step_is_that_of_the_state_reached():
    run = SimpleNamespace(t=0.0, guard_values=lambda t, y: [y[0]])
    kept = KeptGuards(run, [1.0])
    event = kept.event(0)
    # A step that is taken again may end where an earlier one was looked at on its way.
    for k in range(200):
        kept.within(0.001 * k, [1.0], [0])
    assert kept.at_end(0.0, 0.1, [-1e-20], [0]) == [-1e-20]
    # solve_ivp asks again at both ends, with the state of the interpolant there.
    assert event(0.1, [1e-20]) == -1e-20
    assert event(0.0, [-1e-20]) == 1.0
