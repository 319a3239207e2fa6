"""A pendulum is let go and its angle filmed: half a second of it tells nothing of a weak drag."""

import pytest
from filmed_swings import DECLARED, INERTIA, LASTS, filmed

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.replay import in_windows
from simpter_hybrid.identification.recordings.groups import groups_of

TRIED = ("quadratic-drag", "viscous-drag", "stribeck", "asymmetry", "spring-force", "drift")


@pytest.mark.slow
@pytest.mark.parametrize("drag", [0.0, 0.001])
def test_a_weak_drag_is_named_and_none_is_not(tmp_path, drag):
    recording = as_axis(filmed(tmp_path, drag))
    library = bench_of(recording, DECLARED, groups_of(recording)).candidates
    tried = [c for c in library if c.name in TRIED]
    done = diagnose(recording, DECLARED, tried).search
    named = [e.name for e in done.corrected.effects]
    assert named == (["quadratic-drag"] if drag else [])
    if drag:
        found = next(v for k, v in done.corrected.values.items() if k.startswith("quadratic-drag"))
        # Weight over inertia is all that a swing shows: sizes go with the inertia.
        scale = done.corrected.values["inertia"] * 0.022 / INERTIA
        assert found / scale == pytest.approx(drag, rel=0.1)


def test_what_is_compared_is_one_window_and_what_is_traced_many(tmp_path):
    replay = axis_replays(as_axis(filmed(tmp_path)), AxisSignals())[0]
    assert (replay.restarts, replay.observed["position"].windows) == ((), (0,))
    cut = in_windows(replay)
    assert cut.restarts == replay.followed
    assert len(cut.observed["position"].windows) == round(LASTS / 0.5)
    assert cut.observed["position"].lines
