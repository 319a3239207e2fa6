"""A size for every clutch, of which runs show one: the others go, unless they do something."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
import robot_replays as robot
from toy_rig import ALONG_X, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.narrowing import narrowed
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.identification.tip.rig import TipRig

SIZES = {"1": Parameter("each.1.gain", 0.0, -5.0, 5.0, 0.05),
         "2": Parameter("each.2.gain", 0.0, -5.0, 5.0, 0.05)}  # fmt: skip


@dataclass(frozen=True)
class Each(Candidate):
    """One size along x, one along y."""

    @property
    def places(self):
        return tuple(p.name.split(".")[1] for p in self.parameters)

    def only(self, places):
        kept = tuple(SIZES[p] for p in places)
        return replace(self, parameters=kept, starts=((0.1,) * len(kept),), at=tuple(places))


EACH = Each(
    "each", tuple(SIZES.values()), ((0.1, 0.1),), "x", "friction", ALONG_X.coordinates,
    sizes=("each.1.gain", "each.2.gain"),
)  # fmt: skip


class Two(ToyRig):
    """Along x and along y by a gain of its own."""

    def extended(self, candidate):
        return Two((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        gain, other = values.get("each.1.gain", 0.0), values.get("each.2.gain", 0.0)
        return super().predict({**values, "gain": gain, "other": other}, replays)


# Of 0.012 a fit's squares rise by 0.7 %: next to nothing beside 0.3, and not beside 0.05.
@pytest.mark.parametrize(
    ("gain", "other", "at"),
    [(0.3, 0.0, ("1",)), (0.3, 0.03, ()), (0.3, 0.012, ("1",)), (0.05, 0.012, ())],
)
def test_what_only_noise_has_fitted_goes(gain, other, at):
    def run(name, seed):
        made = toy_replay(name, seed, gain=gain)
        seen = made.observed["torque"]
        values = seen.values + other * made.inputs["y"]
        return replace(made, observed={"torque": replace(seen, values=values)})

    split = Split([run("one", 1)], [run("two", 2)], [])
    base = refitted(Two(), split)
    (trial,) = try_candidates(base, [EACH], split, floor=0.1)
    found = narrowed(base, trial, split, 0.1, Memory())
    assert found.candidate.at == at
    # Two thousand samples of 0.1 on a sine of size 1: 0.003.
    assert found.fit.values["each.1.gain"] == pytest.approx(gain, abs=0.01)


def test_the_share_that_is_told_is_of_the_floor_that_is_asked():
    split = Split([toy_replay("one", 1, gain=0.3)], [toy_replay("two", 2, gain=0.3)], [])
    base, memory = refitted(Two(), split), Memory()
    shares = []
    for floor in (0.1, 0.2):
        (trial,) = try_candidates(base, [EACH], split, floor=floor)
        found = narrowed(base, trial, split, floor, memory)
        assert found.candidate.at == ("1",)
        shares.append(found.share)
        # Next to nothing is left by the one place that is not left by both.
        assert found.share == pytest.approx(trial.share, rel=0.01)
    assert shares[1] > shares[0]


def library():
    found = robot.candidates()
    kinds = tip_candidates(2, 4, (0.1, 0.1), 20.0, 1.0)
    return found | {c.name: c for c in kinds}


@pytest.mark.parametrize(
    ("name", "place", "size"),
    [("torque-scale by clutch", "2", -0.3), ("asymmetry by clutch", "2", 0.5),
     ("cross-coupling", "2 from 1", 0.3), ("viscous-drag by joint", "1", 5.0)],
)  # fmt: skip
def test_at_one_place_it_does_what_it_does_with_nothing_at_the_others(name, place, size):
    candidate = library()[name]
    alone = candidate.only([place])
    assert len(alone.effects()) <= 1
    (own,) = (p.name for p in alone.parameters if f".{place}." in p.name)
    run, model = [robot.replay()], ScenarioPredictor(robot.declared(), TipRig())
    found = []
    for c in (candidate, alone):
        predictor = model.extended(c)
        values = {p.name: p.value for p in predictor.parameters} | {own: size}
        found.append(predictor.predict(values, run)["position_1"][0])
    # Replays are integrated to 1e-7.
    assert found[1] == pytest.approx(found[0], abs=1e-7)
    plain = model.predict({p.name: p.value for p in model.parameters}, run)["position_1"][0]
    assert np.abs(found[1] - plain).max() > 2e-5


def test_elsewhere_the_corrected_model_has_nothing_of_it():
    alone = library()["stribeck by clutch"].only(["2"])
    predictor = ScenarioPredictor(robot.declared(), TipRig()).extended(alone)
    values = {p.name: p.value for p in predictor.parameters} | {"stribeck by clutch.2.rise": 0.5}
    (effect,) = predictor.scenario(values).effects
    assert (effect.clutch, effect.rise) == (1, 0.5)
    assert alone.at == ("clutch 2",)
