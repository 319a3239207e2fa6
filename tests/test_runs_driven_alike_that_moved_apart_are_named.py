"""Runs of one programme that did not move alike: no model explains both, and a reader is told."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.reporting.moved_apart import moved_apart, moved_apart_sentence

TIME = 0.01 * np.arange(400)
DRIVE = np.sin(3.0 * TIME)


def run(name, size, drive=DRIVE, noise=0.0, seed=1):
    """A run whose speed follows a drive, with noise [relative]."""
    generator = np.random.default_rng(seed)
    speed = size * DRIVE + noise * generator.normal(size=TIME.size)
    position = np.cumsum(speed) * 0.01
    notes = {"position": position, "speed": speed, "start": np.array([0.0, speed[0]])}
    return Replay(name, name, TIME, {"drive": drive}, {}, drive_is_exact=False, notes=notes)


def test_they_are_named_with_how_far_farthest_first():
    pairs = moved_apart([run("a", 1.0), run("b", 0.8), run("c", 0.5)])
    assert [(p.one, p.other) for p in pairs] == [("a", "c"), ("b", "c"), ("a", "b")]
    assert [p.part for p in pairs] == pytest.approx([0.5, 0.375, 0.2])


def test_noise_moves_none_apart():
    assert moved_apart([run("a", 1.0, noise=0.3, seed=1), run("b", 1.0, noise=0.3, seed=2)]) == []


@pytest.mark.parametrize(
    "other",
    [
        run("b", 0.5, drive=0.9 * DRIVE),
        replace(run("b", 0.5), setting={"load": 2.0}),
        replace(run("b", 0.5), notes={**run("b", 0.5).notes, "start": np.array([1.0, 0.0])}),
    ],
    ids=["another drive", "another setting", "another start"],
)
def test_nothing_is_said_of_runs_that_are_not_alike_before_they_move(other):
    assert moved_apart([run("a", 1.0), other]) == []


def test_nor_of_runs_under_a_constant_drive():
    still = np.ones(TIME.size)
    assert moved_apart([run("a", 1.0, drive=still), run("b", 0.5, drive=still)]) == []


def test_a_reader_is_told_what_to_do():
    split = SimpleNamespace(select=[run("b", 0.5)], report=[])
    said = moved_apart_sentence(SimpleNamespace(fitted=[run("a", 1.0)], split=split))
    assert "a and b by 50 %" in said
    assert "`constant` of each run" in said
