"""Where nothing turns round, the way since a reversal is the distance."""

from simpter_hybrid.identification.reporting.dependence_text import as_well


def test_what_would_do_as_well_names_one_of_them():
    both = as_well(
        ["force:time", "force:distance", "force:displacement_since_reversal", "force:run"]
    )
    assert both == "any dependence on time and distance or whatever differs from run to run"
    one = as_well(["friction:displacement_since_reversal", "friction:run"])
    assert "displacement since reversal" in one
