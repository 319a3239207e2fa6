"""Parts and p-values of dependences, before anything was added and at the end."""

from simpter_hybrid.identification.reporting.by_curves import by_curves_text
from simpter_hybrid.identification.reporting.dependence_table import dependence_table


def _one(coordinate, gain, p_value):
    return {"coordinate": coordinate, "gain": gain, "p_value": p_value}


FIRST = {"before": {"force": [_one("speed", 0.2, 0.005), _one("slip_velocity", 0.4, 0.01)]},
         "after": {"force": [_one("slip_velocity", 0.1, 0.3)]},
         "named": True, "best": "stribeck"}  # fmt: skip
LAST = {"before": {"force": []}, "after": {"force": [_one("slip_velocity", -0.01, 0.8)]},
        "named": True, "best": "asymmetry"}  # fmt: skip
REFUSED = {"before": {"force": [_one("slip_velocity", 0.1, 0.3)]}, "after": {"force": []},
           "named": False, "best": "drift"}  # fmt: skip


def test_the_largest_comes_first_and_ends_are_those_of_the_last_round():
    table = dependence_table([FIRST, LAST])
    rows = table.split("<tr>")[2:]
    assert ["slip velocity" in row for row in rows] == [True, False]
    cells = ("force, slip velocity", "40.0 %", "0.01", "0.0 %", "0.8")
    assert all(f"<td>{cell}</td>" in rows[0] for cell in cells)
    assert rows[1].count("<td>-</td>") == 2


def test_what_a_refused_candidate_leaves_is_not_what_was_found_leaves():
    table = dependence_table([FIRST, REFUSED])
    assert "with what was found" in table
    assert "<td>10.0 %</td>" in table


def test_where_nothing_is_named_the_best_candidate_is_called_by_its_name():
    table = dependence_table([REFUSED])
    assert "with drift, which is not named" in table
    assert "with what was found" not in table


OPEN = FIRST | {"after": {"force": [_one("time", 0.5, 0.005)]}}


def test_what_only_a_later_round_depends_on_is_listed_by_its_size():
    unknown = {"before": OPEN["after"], "after": {"force": []}, "named": False, "best": None}
    first, *others = dependence_table([OPEN, unknown]).split("<tr>")[2:]
    cells = ("force, time", "-", "-", "50.0 %", "0.005")
    assert first.startswith("".join(f"<td>{cell}</td>" for cell in cells))
    assert len(others) == 2


def test_what_the_search_went_on_with_and_the_verdict_does_not_name_is_not_found():
    table = dependence_table([OPEN, REFUSED], named=False)
    assert "with stribeck, which is not named" in table
    assert "with what was found" not in table
    assert "with stribeck and asymmetry, which are not" in dependence_table(
        [OPEN, LAST], False, False
    )


def _ringing(gain, p_value):
    spectrum = {"centres": [8.0, 52.0], "added": [1.0, 1.0 / (1.0 - gain)], "scaled": [1.0, 9.0]}
    return {"ringing": [_one("breakaway", gain, p_value) | spectrum]}


def test_what_rings_is_told_by_its_line_below_the_parts_of_mean_squares():
    first = FIRST | {"before": {"force": [_one("speed", 0.1, 0.005)]} | _ringing(0.9, 0.001)}
    text = dependence_table([first, LAST])
    *_, row = text.split("<tr>")
    assert row.startswith("<td>ringing, after breakaways</td><td>52 Hz, 10 times the spectrum</td>")
    assert "how far it stands out of the spectrum" in text


def test_a_line_beside_a_force_that_shows_a_coordinate_is_called_no_finding():
    first = FIRST | {"before": FIRST["before"] | _ringing(0.9, 0.001)}
    assert "breakaways (no finding beside what forces show)</td>" in dependence_table([first, LAST])


def test_a_largest_line_that_is_none_by_the_rule_is_not_listed():
    for gain, p_value in ((0.75, 1e-9), (0.9, 0.2)):
        first = FIRST | {"before": FIRST["before"] | _ringing(gain, p_value)}
        assert "ringing" not in dependence_table([first, LAST])


BACK = {"force": [_one("back_pressure", 0.003, 0.4)]}


def test_a_channel_that_was_asked_and_told_nothing_is_listed():
    text = dependence_table([REFUSED | {"logged": BACK}])
    *_, row = text.split("<tr>")
    cells = ("force, back pressure (logged)", "0.3 %", "0.4", "", "")
    assert row.startswith("".join(f"<td>{cell}</td>" for cell in cells))
    assert "Channels that the model does not read are all listed" in text


def test_a_channel_is_asked_again_with_what_was_found_and_listed_once():
    first = FIRST | {"logged": BACK, "before": {"force": [*BACK["force"], _one("speed", 0.2, 0.1)]}}
    last = REFUSED | {"logged": {"force": [_one("back_pressure", 0.002, 0.6)]}}
    text = dependence_table([first, last])
    assert text.count("back pressure") == 1
    assert "<td>0.3 %</td><td>0.4</td><td>0.2 %</td><td>0.6</td>" in text


def test_without_rounds_nothing_was_looked_for():
    assert "Nothing was looked for" in dependence_table([])


def _told(*coordinates, curve="force:time"):
    empirical = {"coordinate": curve, "gain": 0.31} if curve else None
    return by_curves_text(
        {"rounds": [FIRST, REFUSED], "depends_on": coordinates, "empirical": empirical}
    )


def test_what_curves_alone_tell_is_said_below_it():
    text = _told("force:time", "force:slip_velocity", "force:position")
    assert "depends on time and position this table does not show" in text
    assert "the best, over time, lowers the error of the runs that select by 31 %" in text
    assert "nearly as well" in text
    assert "nearly as well" not in _told("force:time")


def test_what_it_shows_needs_no_word():
    assert _told("force:slip_velocity", "force:speed", curve="force:speed") == ""
    assert _told("force:time", curve=None) == ""
