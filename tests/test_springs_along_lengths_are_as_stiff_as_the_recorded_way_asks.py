"""Two joints along lengths: newtons over metres, waves of friction and energies by the way."""

import math
from dataclasses import replace

import numpy as np
import pytest
from two_joints import declared_joints

from simpter_hybrid.device import Device
from simpter_hybrid.identification.fitting.replay import Replay
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.identification.tip.ways import Ways, unit_ways, ways_of

FORCE, SPEED = 8.0, 0.5
#: Ways of two slides [m].
WENT = (0.14, 0.07)


def library(ways):
    found = tip_candidates(2, 2, (1.5, 0.8), FORCE, SPEED, pose=(0.01, 0.02), ways=ways)
    return {c.name: c for c in found}


def slides(lengths=(True, True)):
    slips = tuple(w if is_length else 0.0 for w, is_length in zip(WENT, lengths, strict=True))
    return library(Ways(lengths, WENT, slips, (FORCE, 0.1), (SPEED, 9.0)))


def angles():
    return library(unit_ways((False, False), 2, FORCE, SPEED))


def parameters(candidate):
    return {p.name.removeprefix(f"{candidate.name}."): p for p in candidate.parameters}


def test_a_spring_of_each_joint_may_pull_with_the_force_over_the_joints_own_way():
    made = library(Ways((True, True), WENT, WENT, (FORCE, FORCE), (SPEED, SPEED)))
    spring = parameters(made["spring-force"])
    for j, way in enumerate(WENT):
        stiffness = spring[f"{j + 1}.stiffness"]
        assert stiffness.upper >= 10.0 * FORCE / way
        assert stiffness.typical == pytest.approx(0.003 * FORCE / way)
        assert spring[f"{j + 1}.rest"].upper >= WENT[j]


def test_friction_by_place_comes_again_within_the_way_and_not_in_two_pi_metres():
    own = slides()["position-friction by clutch"].effects()
    assert [effect.turn for effect in own] == list(WENT)
    turning = angles()["position-friction by clutch"].effects()
    assert [effect.turn for effect in turning] == [2.0 * math.pi] * 2


def test_a_warm_up_by_less_than_a_joule_is_looked_for_where_little_work_is_done():
    assert parameters(slides()["warm-up"])["energy"].lower < 0.1 * FORCE * WENT[0]
    assert parameters(angles()["warm-up"])["energy"].lower == 1.0


def test_a_length_and_an_angle_have_sizes_of_their_own_and_none_in_common():
    mixed = slides((True, False))
    assert "viscous-drag" not in mixed
    drag = parameters(mixed["viscous-drag by joint"])
    assert drag["1.coefficient"].upper == pytest.approx(2.0 * FORCE / SPEED)
    assert drag["2.coefficient"].upper == pytest.approx(2.0 * 0.1 / 9.0)
    assert [effect.coordinate for effect in mixed["tilt"].effects()] == [1]


class TwoSlides(Device):
    """As much of a device as ways are taken from."""

    coordinates = ("first", "second")
    coordinate_dimensions = ("length", "length")
    surfaces = ("rail one", "rail two")

    @staticmethod
    def clutch_map(q, p, out):
        out[0], out[1], out[2], out[3] = 1.0, 0.0, 0.0, 1.0


def recorded(went):
    time = np.linspace(0.0, 1.0, 11)
    notes = {"position": np.outer(went, time), "speed": np.outer(went, np.ones(11))}
    run = Replay("run 1", "1", time, {}, {}, drive_is_exact=False, notes=notes)
    declared = replace(declared_joints(), device=TwoSlides())
    return ways_of(declared, [run], (1.0, 1.0), FORCE, SPEED)


def test_ways_are_those_of_the_record():
    ways = recorded(WENT)
    assert ways.joints == pytest.approx(WENT)
    assert ways.slips == pytest.approx(WENT)
    assert ways.forces == (FORCE, FORCE)


def test_what_stands_still_has_a_way_all_the_same():
    assert recorded((0.14, 0.0)).joints == pytest.approx((0.14, 0.0014))
