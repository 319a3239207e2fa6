"""What a search may simulate is bounded by steps: it ends at the same place and tells it."""

import pytest
from sprung_mass import MODEL, recorded

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.reporting.cautions import cut_short_sentence, in_view_of

SPRUNG = MODEL[MODEL.index("[[effects]]") : MODEL.index("[[tolerances]]")]
TOLERATED = MODEL[MODEL.index("[[tolerances]]") :].partition('[[tolerances]]\nname = "friction')[0]
FORGOTTEN = parse(MODEL.replace(SPRUNG, "").replace(TOLERATED, ""))


def searched(folder, effort):
    recording = recorded(folder)
    tried = bench_of(recording, FORGOTTEN, groups_of(recording)).candidates
    tried = [c for c in tried if c.name == "viscous-drag"]
    return diagnose(recording, FORGOTTEN, tried, effort=effort)


@pytest.mark.slow
def test_at_the_same_step_every_time_with_what_was_found_by_then(tmp_path):
    first, again = (searched(tmp_path, 1e-6) for _ in range(2))
    assert first.cut_short == again.cut_short > 0.0
    assert first.search.refitted.values == again.search.refitted.values
    assert first.search.corrected.effects == ()


def test_models_that_extend_one_another_count_together(tmp_path):
    recording = recorded(tmp_path)
    bench = bench_of(recording, FORGOTTEN, groups_of(recording))
    larger = bench.predictor.extended(bench.candidates[0])
    assert larger.effort is bench.predictor.effort
    larger.effort.most = 0.0
    larger.effort.add(1.0)
    assert bench.predictor.effort.used_up
    assert not Effort().used_up


def test_a_reader_is_told_before_the_verdict():
    assert cut_short_sentence(0.0, 3) == ""
    told = cut_short_sentence(6.1e8, 3)
    assert "610 million steps" in told
    assert "3 candidates not fitted" in told
    sentence = in_view_of({}, "Nothing is missing.", (), 6.1e8)
    assert sentence == "As far as the search went: nothing is missing."


def test_a_pass_that_was_not_finished_is_said_not_to_be_used():
    told = cut_short_sentence(6.1e8, 3, unfinished=True)
    assert "610 million steps" in told
    assert "its last pass was not finished and is not used" in told
    assert "3 candidates" not in told
    assert told.endswith("goes on for three times as long.")
    assert cut_short_sentence(6.1e8, 3, True, True).endswith("had been found before it.")


def test_a_lack_of_which_not_all_was_tried_is_no_plain_unknown():
    lack = "Something is missing: 1.4 times. None of the known effects explains it."
    assert "None of the known effects that were tried (35 were not)" in in_view_of(
        {}, lack, (), 6.1e8, 35
    )
    lack = "Something is missing and none of the known effects explains it: it depends on speed."
    said = in_view_of({}, lack, (), 6.1e8, 35)
    assert "none of the known effects that were tried (35 were not) explains it" in said
    said = in_view_of({}, lack, (), 6.1e8, 35, of=35)
    assert "something is missing and no effect was fitted: it depends on speed" in said
    lack = "The drag differs from run to run. No effect of the library does that."
    said = in_view_of({}, lack, (), 6.1e8, 35)
    assert "No effect of the library that was tried (35 were not) does that" in said
    lack = "Something is missing and none of the known effects explains it: it depends on speed."
    assert in_view_of({}, lack, (), 6.1e8, 0).endswith("none of the known effects explains it: "
                                                       "it depends on speed.")  # fmt: skip
