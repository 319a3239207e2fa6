"""A weight or a friction that a run was made with stays while that run goes on."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.recordings.groups import several


def run(name: str, cut_from: str = "", piece: int = 0) -> Some:
    return Some(name=name, cut_from=cut_from, piece=piece)


@pytest.mark.parametrize(
    ("runs", "more"),
    [
        ([run("first"), run("second")], True),
        ([run("swing, piece 1", "swing", 1), run("swing, piece 2", "swing", 2)], False),
        ([run("piece 1", piece=1), run("piece 2", piece=2)], False),
        ([run("a, piece 1", "a", 1), run("a, piece 2", "a", 2), run("b")], True),
    ],
)
def test_pieces_of_one_run_are_not_made_anew(runs: list[Some], more: bool) -> None:
    assert several(Some(runs=runs)) is more
