"""A refit that makes up for a lack in some kinds of runs leaves others far worse than declared."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.reporting.spoilt_kinds import spoilt_kinds_sentence, spoilt_told


def found(effects=(), kind="unknown", ruling=None):
    model = Some(select_error=2.7, effects=effects)
    search = Some(corrected=model, floor=1.0, verdict=Some(kind=kind))
    return Some(search=search, levels=(), ruling_run=ruling)


def errors(declared, refitted, after=None, **floor):
    return {"declared": declared, "refitted": refitted, "after": after or refitted, **floor}


# Those of a tester's clutch that warms over a minute.
HELD_OUT = {"run 3": errors(9.8, 4.9), "run 7": errors(1.51, 2.60), "run 11": errors(1.20, 4.95)}


def runs(held_out):
    return {"fit": [{"run": n, "experiment": n, **e} for n, e in held_out.items()]}


def test_the_kinds_are_named_with_what_they_were_the_worst_first():
    told = spoilt_kinds_sentence(found(), HELD_OUT, runs(HELD_OUT))
    assert "far worse refitted than as declared (run 11 1.2 to 4.95, run 7 1.51 to 2.6 " in told
    assert "no measurement" in told


def test_so_are_those_that_no_run_held_out_is_of():
    assert "run 7 1.51 to 2.6" in spoilt_kinds_sentence(found(), {}, runs(HELD_OUT))


def test_what_was_found_may_spoil_them_too():
    wear = Some(name="wear")
    one = {"slow": errors(1.3, 1.2, 3.0)}
    told = spoilt_kinds_sentence(found([wear]), one, runs(one))
    assert "far worse with what was found than without it (slow 1.2 to 3 times the floor)" in told


@pytest.mark.parametrize(
    "one",
    [
        errors(1.1, 1.9),  # near the floor
        errors(9.0, 14.0),  # worse, but not twice as far from it
        errors(1.2, 2.9, floor=1.6),  # its repeated runs differ so
        errors(1.2, 4.0, 1.1),  # what was found mends it
        errors(float("nan"), 4.0),
    ],
)
def test_nothing_is_said_of_others(one):
    assert spoilt_kinds_sentence(found(), {"slow": one}, runs({"slow": one})) == ""


def test_what_is_told_already_is_not_said_again():
    fitted = {"fast": errors(1.0, 1.1)}  # so far from these it is told of as uneven
    assert spoilt_kinds_sentence(found(), {"fast": errors(1.2, 9.0)}, runs(fitted)) == ""
    assert spoilt_told(found(ruling=Some(name="run 3")), HELD_OUT, runs(HELD_OUT)) == ""
