"""Devices with and without a tip, with and without desired torques; the same bytes twice."""

import pytest
from devices_for_tests import Block, always_on
from sampled_runs import baseline, locked, oscillator

from simpter_hybrid.engine import simulate
from simpter_hybrid.plots import THESIS, figures, plot, png
from simpter_hybrid.scenario import Scenario

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


def test_surfaces_between_sliding_bodies_are_shown_in_newtons():
    class Sliding(Block):
        coordinate_dimensions = ("length",)

    run = simulate(Scenario("s", Sliding(), (always_on(1.0, 1.0),), (0.0,), (1.0,), 0.2))
    labels = {ax.get_ylabel() for picture in figures(run).values() for ax in picture.axes}
    assert {"slip [m/s]", "force [N]"} <= labels
