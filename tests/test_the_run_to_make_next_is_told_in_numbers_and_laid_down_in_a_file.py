"""What is laid down in the run to make next: words, a file, a picture."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.identifiability_report import Sight
from simpter_hybrid.identification.recordings.channel_map import ChannelMap
from simpter_hybrid.identification.reporting.next_runs import next_runs, next_runs_csv
from simpter_hybrid.identification.reporting.sight_sentences import blind_sentence, shown_by
from simpter_hybrid.plots.next_run import next_run_pictures

TIME = 0.1 * np.arange(101)
#: To and fro at 0.02 m/s, 0.05 m to both sides, from 0.1 m on.
STROKES = 0.1 + 0.05 * 2 / np.pi * np.arcsin(np.sin(0.5 * np.pi * 0.02 / 0.05 * TIME))
#: In millimetres, turned round, and 5 mm off.
POSITION = ChannelMap("position", "x", "mm", "measured", scale=1e-3, shift=5e-3, sign=-1)
PRESSURE = ChannelMap("pressure", "p", "kPa", "input", scale=1e3)


def planned(name, laid_down, experiment="strokes"):
    return Replay(name, experiment, TIME, {}, {}, laid_down=laid_down)


def asked(*runs):
    sight = Sight({}, (), (), {}, planned=runs)
    channels = {"position": POSITION, "pressure": PRESSURE}
    return next_runs(sight, SimpleNamespace(channels=channels))


def test_words_and_numbers_are_those_of_the_record():
    laid_down = {"position": STROKES, "pressure": np.full(101, 2e5)}
    one = asked(planned("strokes", laid_down))["strokes"]
    # 0.05 to 0.15 m, as -55 to -155 mm in a column with that sign and offset.
    assert one.words == "10 s: position -155 to -55 mm at up to 20 mm/s, pressure 200 kPa"
    head, first, *rest = next_runs_csv([one]).splitlines()
    assert head == "experiment,run,t [s],position (x) [mm],pressure (p) [kPa]"
    assert first == "strokes,strokes,0,-105,200"
    assert len(rest) == 100


def test_thousands_are_written_as_a_person_writes_them():
    one = asked(planned("strokes", {"position": 100.0 * STROKES}))["strokes"]
    assert one.words == "10 s: position -15,000 to -5,010 mm at up to 2,000 mm/s"


def test_several_runs_of_an_experiment_stand_one_after_the_other():
    runs = [planned(f"strokes, {k}", {"position": STROKES + 0.1 * k}) for k in range(2)]
    one = asked(*runs)["strokes"]
    assert one.words == "2 runs of 10 s: position -255 to -55 mm at up to 20 mm/s"
    rows = next_runs_csv([one]).splitlines()[1:]
    assert [row.startswith('strokes,"strokes, 1",') for row in rows] == [False] * 101 + [True] * 101


def test_a_release_is_told_by_how_it_begins_and_has_no_course():
    one = asked(planned("let go", {"position": np.array([0.1, 0.103])}, "let go"))["let go"]
    assert one.words == "10 s: let go at position -105 mm with -30 mm/s"
    assert one.runs == ()
    laid_down = {"position": np.array([0.1, 0.1]), "pressure": np.full(101, 2e5)}
    rests = asked(planned("let go", laid_down, "let go"))["let go"]
    assert rests.words == "10 s: let go at position -105 mm with 0 mm/s, pressure 200 kPa"
    assert next_runs_csv([one]) == ""
    assert next_run_pictures([one]) == {}


def test_what_a_replay_leaves_out_at_its_end_is_laid_down_all_the_same():
    short = Replay("strokes", "strokes", TIME[:-1], {}, {}, laid_down={"position": STROKES})
    rows = next_runs_csv([asked(short)["strokes"]]).splitlines()
    assert len(rows) == 1 + STROKES.size


def test_of_a_drive_beside_its_motion_is_told_who_is_told_which():
    laid_down = {"position": STROKES, "drive": np.linspace(-12.0, 12.0, 101)}
    sight = Sight({}, (), (), {}, planned=[planned("strokes", laid_down)])
    volts = ChannelMap("drive", "U", "V", "input")
    channels = {"position": POSITION, "drive": volts}
    one = next_runs(sight, SimpleNamespace(channels=channels))["strokes"]
    assert one.words == (
        "10 s: position -155 to -55 mm at up to 20 mm/s, drive -12 to 12 V"
        " (a driver is told the drive, a servo the position)"
    )
    assert next_runs_csv([one]).startswith("experiment,run,t [s],position (x) [mm],drive (U) [V]")


def test_a_course_is_drawn():
    one = asked(planned("strokes", {"position": STROKES}))["strokes"]
    assert next_run_pictures([one])["run_next"].startswith(b"\x89PNG")


def test_what_the_runs_do_not_show_is_asked_of_the_experiments_that_show_it_most():
    reveals = {
        "a lag": (("steps", 40.0), ("strokes", 30.0)), "a play": (("steps", 20.0),),
        "stribeck": (("strokes", 30.0),), "wear": (("strokes", 5.0),),
    }  # fmt: skip
    needed = {"steps": 10.0, "strokes": 10.0}
    sight = Sight({}, tuple(reveals), (), {}, reveals, needed, [planned("strokes", {})])
    shown = shown_by(sight, list(reveals))
    assert shown == {"steps": ["a lag", "a play"], "strokes": ["stribeck"]}
    assert blind_sentence(list(reveals), shown).endswith(
        "Run next, to see a lag and a play: steps; to see stribeck: strokes (what is laid down "
        "stands in the report)."
    )
    assert "no effect of the library but a gain would show" in blind_sentence("ab", {}, ["a gain"])
    assert "these would not show in these data: a, b." in blind_sentence("ab", {}, ["c", "d"])
    many = ["wave-3", "play-2", "wave-4", "wave-5", "wave-x", "play-4"]
    assert ": wave-3 to -5, play-2, wave-x, play-4." in blind_sentence(many)
    five = {"steps": list("abcde")}
    assert "to see a, b, c and 2 more: steps" in blind_sentence(list("abcde"), five)


@pytest.mark.parametrize("sight", [None, Sight({}, (), (), {})])
def test_where_nothing_is_planned_nothing_is_told(sight):
    assert next_runs(sight, SimpleNamespace(channels={})) == {}
    assert shown_by(sight, ["a lag"]) == {}
