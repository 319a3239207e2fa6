"""What a prompt prints after ``simpter.run(...)``: not arrays."""

from sampled_runs import oscillator


def test_it_says_what_ran_and_how_it_ended():
    run = oscillator()
    assert repr(run).startswith(f"<Trajectory {run.scenario.name}, finished: ")
    assert f"{len(run.events)} events" in repr(run)
    assert len(repr(run)) < 200
