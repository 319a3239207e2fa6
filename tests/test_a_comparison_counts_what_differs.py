"""Events of two runs are paired; what is missed, invented, shifted, drifts or drives is counted."""

import json
from dataclasses import replace

import numpy as np
import pytest
from devices_for_tests import Block, Ramp, TwoBlocks, always_on

from simpter_hybrid.comparison import compare, karnopp
from simpter_hybrid.comparison.bounds import exceeded
from simpter_hybrid.comparison.compare import energy_faults
from simpter_hybrid.comparison.events import Change, match
from simpter_hybrid.comparison.states import states_at
from simpter_hybrid.comparison.table import text_of
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.effects.added_inertia import AddedInertia
from simpter_hybrid.engine import simulate
from simpter_hybrid.loads.ramp import RampOnCoordinate
from simpter_hybrid.scenario import Scenario

ON = {"command": (1.0,), "excitation": (1.0,)}


def ramp(brk: float) -> Scenario:
    """A block released by a ramp of 1 N/s at t = brk, slip friction 1 N."""
    return Scenario(
        "ramp", Block(2.0), (always_on(1.0, brk),), (0.0,), (0.0,), 3.0,
        loads=(Ramp(0.0, ((0.0, 0.0), (3.0, 3.0))),), **ON,
    )  # fmt: skip


def test_the_closest_of_the_same_kind_are_pairs():
    mine = [Change(1.0, 1, 0), Change(1.5, 1, 1), Change(2.0, 2, 0)]
    theirs = [Change(1.004, 1, 0), Change(1.001, 1, 0), Change(1.5, 1, -1), Change(2.5, 2, 0)]
    found = match(mine, theirs, 0.02)
    assert found.pairs == ((mine[0], theirs[1]),)
    assert found.missed == (mine[1], mine[2])
    assert found.invented == (theirs[0], theirs[2], theirs[3])
    assert found.largest_shift == pytest.approx(1e-3, abs=1e-12)


def test_a_run_without_a_gap_differs_only_by_the_tolerance():
    row = compare(ramp(1.0), [karnopp(1e-3)]).rows[0]
    assert (row.matched, row.missed, row.invented) == (1, 0, 0)
    assert row.final_error < 1e-5
    # The step that ends after the release still counts as stuck: its slip is of third order.
    assert row.drift < 1e-8
    assert row.energy_created is None  # a spring without a potential: nothing to balance


def test_what_the_limiter_swallows_is_energy_created():
    # In the band the block gathers 1/2 m band^2 without moving: nothing has done that work.
    two = ramp(1.0).replace(
        device=TwoBlocks(2.0), clutches=(always_on(1.0, 1.0),) * 2, q=(0.0, 0.0), qd=(0.0, 0.0),
        command=(1.0, 1.0), excitation=(1.0, 1.0),
    )  # fmt: skip
    row = compare(two, [karnopp(1e-1, "thesis", rtol=1e-8)]).rows[0]
    assert row.energy_created == pytest.approx(0.5 * 2.0 * 1e-2, rel=0.02)


def test_a_bound_that_is_exceeded_is_named():
    found = compare(ramp(1.3), [karnopp(1e-1), karnopp(1e-5)])
    broken = exceeded(found, {"final_error": 1e-2, "missed": 0.0})
    assert [b.candidate for b in broken] == ["Karnopp (tuned), band 0.1"]
    assert "final_error" in str(broken[0])
    with pytest.raises(KeyError, match="cannot be bounded"):
        exceeded(found, {"beauty": 1.0})


def test_the_same_comparison_gives_the_same_bytes():
    texts = []
    for _ in range(2):
        found = compare(ramp(1.3), [karnopp(1e-2)])
        texts.append(json.dumps(found.as_dict()) + text_of(found))
    assert texts[0] == texts[1]
    assert "cpu" not in texts[0]


def test_a_run_that_chatters_is_told_below_the_table():
    found = compare(ramp(1.3), [karnopp(1e-2)])
    busy = replace(found.runs[0], statistics={"steps": 5_000, "rejected_steps": 9_000})
    last = text_of(replace(found, runs=(busy,))).splitlines()[-1]
    assert last.startswith(f"{found.rows[0].name} chatters on the edge of its band: 9000 of 14000")
    assert "chatters" not in text_of(found)


def test_inertia_that_an_effect_adds_stores_energy_too():
    # A kilogram with another one added, slowed down by 2 N: it gives what it had stored, 1 J.
    run = Scenario(
        "axis", LinearAxis(mass=1.0), (always_on(1.0, 1.0),), (0.0,), (1.0,), 1.0,
        loads=(RampOnCoordinate(base=-2.0),),
        effects=(AddedInertia(coordinate=0, inertia_change=1.0),),
    )  # fmt: skip
    exact = simulate(run)
    created, _ = energy_faults(run, states_at(exact, np.linspace(0.0, 1.0, 11)))
    # Rounding; of the device's kilogram alone 0.5 J come out of nothing.
    assert created == pytest.approx(0.0, abs=1e-9)
