from dataclasses import replace
from types import SimpleNamespace

import pytest
from toy_rig import ToyRig, toy_replay

from simpter_hybrid.identification import doubted_readings
from simpter_hybrid.identification.fitting.replay import Restart
from simpter_hybrid.identification.fitting.replicates import merged


@pytest.mark.parametrize("begins", [(), (Restart(5, 0.0, 0.0),)], ids=["alike", "otherwise"])
@pytest.mark.parametrize("part", ["select", "fit"])
def test_what_is_read_otherwise_is_merged_as_what_was_fitted(monkeypatch, part, begins):
    fit = [toy_replay("1", 1), toy_replay("2", 2), toy_replay("3", 3, experiment="b")]
    select = [toy_replay("4", 4)]

    def made(recording, part):
        """The same runs by a sensor that shows half as much; the first may begin otherwise."""
        runs = [
            replace(r, observed={"torque": replace(seen, values=0.5 * seen.values)},
                    notes={"read": r.time})
            for r in (fit if part == "fit" else select) for seen in r.observed.values()
        ]  # fmt: skip
        return [replace(runs[0], restarts=begins), *runs[1:]]

    bench = SimpleNamespace(predictor=ToyRig(), parts={"fit": fit, "select": select}, made=made)
    monkeypatch.setattr(doubted_readings, "_same", lambda one, other: False)
    assert len(merged(fit)) < len(fit)
    asked = [
        SimpleNamespace(made=lambda recording: recording, factors=lambda _, f=factors: f)
        for factors in ({}, {"torque": 0.5})
    ]
    runs = fit if part == "fit" else select
    judged = doubted_readings.Judged(part, runs, 1.0, 1.0, 1.0)
    values = {"scale": 1.0}
    found = doubted_readings._left_by_changes(bench, None, asked, values, fit, judged)
    assert [change for change, _ in found] == asked
    held, halved = found
    # Half the noise of 0.1 over a scale that is fitted; 2000 samples tell it to 1.6 %.
    assert held[1] == pytest.approx(0.5, rel=0.05)
    # A sensor that showed half as much has half the noise, too.
    assert halved[1] == pytest.approx(1.0, rel=0.05)
