"""What was logged beside locates an unknown if it tells clearly more; a copy tells no more."""

from dataclasses import replace

import numpy as np
import pytest

from simpter_hybrid.identification.empirical_terms import terms_over
from simpter_hybrid.identification.tracing.logged import (
    instead,
    on_logged,
    told_apart,
    with_logged,
)
from simpter_hybrid.identification.tracing.signature import dependences
from simpter_hybrid.identification.tracing.trace import Trace


def _traces(cause: str) -> list[Trace]:
    """Two runs whose residual follows `cause`; beside the speed its copy was logged."""
    generator = np.random.default_rng(1)
    found = []
    for _ in range(2):
        wander = np.cumsum(generator.standard_normal((2, 3000)), axis=1)
        speed, temperature = wander / np.std(wander, axis=1)[:, None]
        copy = speed + 0.01 * generator.standard_normal(speed.size)
        residual = {"speed": speed, "temperature": temperature}[cause]
        residual = residual + generator.standard_normal(speed.size)
        logged = {"temperature": temperature, "speed_2": copy}
        found.append(Trace(residual, np.ones(speed.size), {"speed": speed}, logged=logged))
    return found


def _told(cause: str):
    learned, tested = ([t] for t in _traces(cause))
    before = {"force": tuple(dependences(learned, tested))}
    return with_logged(before, {"force": on_logged(learned, tested)})


def test_a_temperature_is_named_and_shown_with_its_curve():
    shown, told = _told("temperature")
    assert told == ("force:temperature",)
    assert [d.coordinate for d in shown["force"]] == ["temperature", "speed"]
    assert np.ptp(shown["force"][0].added + shown["force"][0].scaled) > 1.0


@pytest.mark.parametrize("name", ["time", "speed", "vibration", "run", "ringing"])
def test_one_that_is_called_as_something_else_is_told_apart_from_it(name):
    runs = []
    for trace in _traces("temperature"):
        along = {**trace.coordinates, "time": np.arange(trace.residual.size) / 100.0}
        logged = told_apart({name: trace.logged["temperature"]}, along)
        runs.append(replace(trace, coordinates=along, logged=logged))
    learned, tested = ([run] for run in runs)
    before = {"force": tuple(dependences(learned, tested))}
    shown, told = with_logged(before, {"force": on_logged(learned, tested)})
    assert told == (f"force:{name} as logged",)
    assert [d.coordinate for d in shown["force"]].count(name) == (name in ("time", "speed"))
    (term,) = terms_over(told[0], {"force": learned})
    assert term.effects()[0].follows() == name


def test_a_second_sensor_tells_no_more_than_the_first():
    shown, told = _told("speed")
    assert told == ()
    assert [d.coordinate for d in shown["force"]] == ["speed"]


@pytest.mark.parametrize(
    ("told", "where"),
    [
        (("force:temperature",), ("force:temperature", "load:time")),
        ((), ("force:run", "load:time")),
    ],
)
def test_a_channel_stands_in_place_of_what_its_balance_told_else(told, where):
    assert instead(("force:run", "load:time"), told) == where


def test_channels_are_thinned_with_the_trace():
    trace = _traces("speed")[0].thinned(10)
    assert trace.logged["temperature"].size == trace.residual.size == 300
    assert on_logged([trace], [replace(trace, logged={})]) == ()
