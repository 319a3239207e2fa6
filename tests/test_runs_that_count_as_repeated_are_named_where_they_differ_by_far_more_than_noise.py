"""What repeated runs differ by is a floor, and a reader has to know which runs those are."""

from simpter_hybrid.identification.reporting.told_apart import repeated_sentence


def test_they_are_listed_with_how_far_they_differ():
    said = repeated_sentence((("a", "b"), ("c", "d", "e")), 12.0)
    assert "(a and b; c and d and e): 12.0 times the noise" in said
    assert "`constant` of each run" in said


def test_only_a_few_are_listed():
    pairs = tuple((f"{k}", f"{k} again") for k in range(5))
    assert "2 and 2 again; and 2 more" in repeated_sentence(pairs, 4.0)


def test_of_those_that_differ_by_noise_nothing_is_said():
    assert repeated_sentence((("a", "b"),), 1.2) == ""
