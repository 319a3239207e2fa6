"""What is held out has no part in a fit: not in its weights either."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import recorded_axis

from simpter_hybrid.identification.recordings.groups import groups_of, holding_out
from simpter_hybrid.identification.recordings.noise import channel_noise

NAME = "position"


@pytest.fixture(scope="module")
def recording(tmp_path_factory):
    return recorded_axis(tmp_path_factory.mktemp("axis"), ())


def noisier(recording, group, more):
    """The recording with `more` noise on the positions of a group's runs."""
    rng = np.random.default_rng(0)

    def of(run):
        told = run.channels[NAME] + more * rng.normal(size=run.time.size) * (run.group == group)
        return replace(run, channels={**run.channels, NAME: told})

    return replace(recording, runs=tuple(map(of, recording.runs)))


def test_noise_of_a_run_held_out_changes_nothing(recording):
    groups = groups_of(recording)
    (held_out,) = set(groups["report"]) - {*groups["fit"], *groups["select"]}
    quiet, loud = (
        channel_noise(noisier(holding_out(recording, groups), held_out, more), NAME)
        for more in (0.0, 1e-3)
    )
    assert loud == quiet


def test_it_is_taken_from_them_where_no_other_run_has_the_channel(recording):
    (group,) = {run.group for run in recording.runs[-1:]}
    alone = replace(recording, runs=recording.runs[-1:], held_out=(group,))
    assert channel_noise(alone, NAME) > 0.0
