"""A weight or a friction that a run was made with stays while that run goes on."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.recordings.groups import several


def run(name: str, cut_from: str = "") -> Some:
    return Some(name=name, cut_from=cut_from)


@pytest.mark.parametrize(
    ("runs", "more"),
    [
        ([run("first"), run("second")], True),
        ([run("swing, piece 1", "swing"), run("swing, piece 2", "swing")], False),
        ([run("a, piece 1", "a"), run("a, piece 2", "a"), run("b")], True),
    ],
)
def test_pieces_of_one_run_are_not_made_anew(runs: list[Some], more: bool) -> None:
    assert several(Some(runs=runs)) is more
