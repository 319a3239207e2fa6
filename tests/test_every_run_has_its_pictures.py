"""Devices with and without a tip, with and without desired torques; the same bytes twice."""

import pytest
from sampled_runs import baseline, locked, oscillator

from simpter_hybrid.plots import THESIS, figures, plot, png

CLUTCHES = ["slip_velocities", "clutch_torques"]
ALWAYS = ["acceleration", "energy_budget"]


@pytest.mark.parametrize(
    ("run", "expected"),
    [
        (baseline, ["tip_path", *CLUTCHES, "torque_following", *ALWAYS]),
        (locked, ["tip_path", *CLUTCHES, *ALWAYS]),
        (oscillator, [*CLUTCHES, *ALWAYS]),
    ],
)
def test_every_run_has_its_pictures(run, expected):
    made = figures(run(), display=THESIS)
    assert list(made) == expected
    for picture in made.values():
        for ax in picture.axes:
            label = ax.get_ylabel()
            assert not label or "[" in label or label == "mode", "an axis without a unit"


def test_a_picture_has_the_same_bytes_twice(tmp_path):
    files = plot(oscillator(), tmp_path)
    for file, picture in zip(files, figures(oscillator()).values(), strict=True):
        assert file.read_bytes() == png(picture)
