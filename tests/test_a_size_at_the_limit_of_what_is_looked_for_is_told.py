"""A force sensor that shows twice as much and more: the fit ends where it may."""

from dataclasses import replace
from types import SimpleNamespace

import pytest
from motor_by_voltage import MODEL

from simpter_hybrid.files.scenario_file import load, parse
from simpter_hybrid.identification.axis.drive import drive_candidates
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.reporting.sentences import at_limit_sentence

FOUND = {c.name: c for c in drive_candidates(load(str(find_model("emps"))), True)}


def said(name, value):
    candidate = FOUND[name]
    model = SimpleNamespace(effects=(candidate,), values={candidate.parameters[0].name: value})
    return at_limit_sentence(SimpleNamespace(search=SimpleNamespace(corrected=model)))


@pytest.mark.parametrize("end", ["lower", "upper"])
def test_either_limit_is_told(end):
    parameter = FOUND["force-gain"].parameters[0]
    assert said("force-gain", getattr(parameter, end)).startswith("force-gain.gain ended at the")


@pytest.mark.parametrize("value", [0.3, 0.0, 0.99])
def test_between_them_nothing_is(value):
    assert said("force-gain", value) == ""


def test_ends_that_are_open_all_the_time_are_no_limit():
    motor = replace(parse(MODEL, "m.toml").loads[0], supply=12.0)
    declared = replace(parse(MODEL, "m.toml"), loads=(motor,))
    coasting = next(c for c in drive_candidates(declared, False) if c.name == "drive-coasting")
    model = SimpleNamespace(effects=(coasting,), values={"drive-coasting.share": 1.0})
    assert at_limit_sentence(SimpleNamespace(search=SimpleNamespace(corrected=model))) == ""


def test_no_lag_at_all_is_no_limit():
    # The lag may be from 0 on, and does nothing there.
    assert said("force-lag", 0.0) == ""
