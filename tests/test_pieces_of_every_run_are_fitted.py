"""Runs cut into pieces, without a split: the first ones of all runs fit, the last are held out."""

from axis_recordings import MAP, written

from simpter_hybrid.identification.recordings.groups import groups_of

ROWS = ["take,ms,angle,torque",
        *(f"{n},{k},{k % 7},{k % 5}" for n in range(2) for k in range(240))]  # fmt: skip


def test_so_that_every_kind_of_motion_is(tmp_path):
    cut = MAP.replace('boundaries = ["take"]', 'boundaries = ["take"]\npieces = 4')
    plain = cut[: cut.index("[split]")] + cut[cut.index("[channels") :]
    assert groups_of(written(tmp_path, ROWS, plain)) == {
        "fit": tuple(f"take {n}, piece {k}" for k in (1, 2) for n in range(2)),
        "select": ("take 0, piece 3", "take 1, piece 3"),
        "report": ("take 0, piece 4", "take 1, piece 4"),
    }
