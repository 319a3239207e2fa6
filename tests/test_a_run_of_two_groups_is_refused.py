"""What calls the group or the experiment of a run does not change within it."""

import pytest
from axis_recordings import MAP, written

from simpter_hybrid.problems import InvalidInput


def _recorded(folder, kinds, key="group", more=""):
    """A take for each list of kinds, which lasts sixty rows for each of them."""
    described = MAP[: MAP.index("[split]")] + MAP[MAP.index("[channels.position]") :]
    described = described.replace('group = ["take"]', f'{key} = ["kind"]\n{more}')
    rows = [
        f"{take},{k},{k % 7},{k % 5},{of[k // 60]}"
        for take, of in enumerate(kinds)
        for k in range(60 * len(of))
    ]
    return written(folder, ["take,ms,angle,torque,kind", *rows], described)


@pytest.mark.parametrize("key", ["group", "experiment"])
@pytest.mark.parametrize(("first", "second"), [("A", "B"), ("1.5", "2")])
def test_with_the_row_at_which_it_changes(tmp_path, key, first, second):
    told = rf"csv:122: column 'kind', by which \[runs\] {key}.*{second} behind {first} in take 1"
    with pytest.raises(InvalidInput, match=f"{told}, and so in 1 more.*boundaries too"):
        _recorded(tmp_path, [[first], [first, second], [second, first]], key)


def test_a_cell_that_is_blank_is_no_other_group(tmp_path):
    recorded = _recorded(tmp_path, [["A", ""], ["B"]])
    assert [run.group for run in recorded.runs] == ["kind A", "kind B"]


def test_rows_that_do_not_count_may_be_of_another(tmp_path):
    recorded = _recorded(tmp_path, [["A", "B"], ["B"]], more='until = "59 ms"')
    assert [run.group for run in recorded.runs] == ["kind A", "kind B"]
