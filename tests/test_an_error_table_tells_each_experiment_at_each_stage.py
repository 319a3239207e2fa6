"""Errors of experiments beside what repeated runs of each differ by, and floors of no sensor."""

from simpter_hybrid.identification.reporting.tables import error_tables

DATA = {
    "error_of_channels": {
        "declared": {"speed": 4.0}, "refitted": {"speed": 3.0}, "after": {"speed": 2.0},
        "floor": {"speed": 2.0},
    },
    "noise_of_channels": {"speed": 1.0},
    "units_of_channels": {},
    "error": {"declared": 2.0, "refitted": 1.5, "after": 1.0, "floor": 1.0},
    "lack_of_fit": {},
    "error_of_experiments": {
        "spin": {"declared": 2.5, "refitted": 1.5, "after": 1.25, "floor": 1.125},
        "sine": {"declared": 1.75, "refitted": 1.375, "after": 0.875},
    },
    "breakaways": [],
    "not_compared": [],
}  # fmt: skip


def test_each_stage_and_the_floor_of_its_own_stand_in_its_row():
    text = error_tables(DATA)
    row = "".join(f"<td>{cell}</td>" for cell in ("spin", "2.5", "1.5", "1.25", "1.125"))
    alone = "".join(f"<td>{cell}</td>" for cell in ("sine", "1.75", "1.375", "0.875", "-"))
    assert row in text
    assert alone in text


def test_runs_that_repeat_worse_than_their_sensors_are_told_of():
    assert "Repeated runs differ by more than the noise" in error_tables(DATA)
    alike = DATA | {"noise_of_channels": {"speed": 1.9}}
    assert "Repeated runs differ by more than the noise" not in error_tables(alike)


def test_what_was_measured_and_is_not_compared_is_named():
    assert "not compared" not in error_tables(DATA)
    assert "no row tells of it: position" in error_tables(DATA | {"not_compared": ["position"]})


def test_levels_of_breakaway_are_in_the_unit_of_their_channel():
    level = {"run": "ramp", "time": 1.0, "rested": 2.0, "measured": 8.0, "sd": 0.5,
             "refitted": 9.0, "after": 8.5}  # fmt: skip
    assert "breakaway [N m]" in error_tables(DATA | {"breakaways": [level]})
    units = {"clutch_torque": ["ozf*in", 0.5]}
    text = error_tables(DATA | {"breakaways": [level], "units_of_channels": units})
    assert "breakaway [ozf*in]" in text
    assert "".join(f"<td>{x}</td>" for x in ("1", "2", "16", "2", "18", "17")) in text
