"""Before anything is computed: a directory that cannot be made, trials fewer than none."""

import argparse
from pathlib import Path

import pytest

from simpter_hybrid.commands.diagnose import check_free
from simpter_hybrid.problems import InvalidInput


def _asked(trials=0):
    return argparse.Namespace(trials=trials, force=False, effort=1.0)


def test_trials_fewer_than_none(tmp_path):
    with pytest.raises(InvalidInput, match="0 or more"):
        check_free(tmp_path / "out", _asked(trials=-3))


def test_a_directory_below_a_file(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(InvalidInput, match="--out"):
        check_free(tmp_path / "file" / "out", _asked())


def test_a_new_directory_is_left_to_be_made(tmp_path):
    check_free(Path(tmp_path / "out"), _asked())
    assert not (tmp_path / "out").exists()
