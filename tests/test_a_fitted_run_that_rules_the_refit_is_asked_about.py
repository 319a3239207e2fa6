"""A hand braked in one fitted run: the refit is ruled by it, and a question says so."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.fitted_model import Split
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.fitting.residual import errors_by_experiment
from simpter_hybrid.identification.reporting.cautions import ruling_run_sentence
from simpter_hybrid.identification.ruling_run import ruling_run

TIME = 0.01 * np.arange(200)
NOISE = 0.01


class Decay:
    """Speeds that fall by a friction, in closed form."""

    parameters = (Parameter("friction", 1.0, 0.3, 3.0, 0.1, 0.2, "1"),)

    def predict(self, values, replays):
        return {"speed": [np.exp(-values["friction"] * r.time) for r in replays]}


def run(name, friction=1.0):
    noise = NOISE * np.random.default_rng(len(name) + ord(name[-1])).standard_normal(TIME.size)
    seen = Observation(np.exp(-friction * TIME) + noise, NOISE, TIME >= 0.0)
    return Replay(name, name, TIME, {}, {"speed": seen})


def done(split, friction, kind="unknown"):
    model = Decay()
    error, _ = errors_by_experiment(model, {"friction": friction}, split.select)
    fitted = SimpleNamespace(
        predictor=model, values={"friction": friction}, select_error=error, unit=1.0
    )
    verdict = SimpleNamespace(kind=kind)
    return SimpleNamespace(refitted=fitted, corrected=fitted, verdict=verdict)


def split(*touched):
    fit = [run(f"run {k}", 1.5 if k in touched else 1.0) for k in range(4)]
    return Split(tuple(fit), (run("run 8"),), (run("run 9"),))


def test_it_is_named_with_what_is_left_without_it():
    found = ruling_run(done(split(2), 1.12), split(2), 1.5)
    assert found.name == "run 2"
    # 1.12 for 1 is off by 0.12 t exp(-t): 0.036, root mean square, of three and a half deviations.
    assert found.left == pytest.approx(1.0 / np.hypot(1.0, 3.6), rel=0.1)
    assert ruling_run_sentence(found).startswith("Did something else act in run 2 alone")


def test_not_where_an_effect_is_plain():
    assert ruling_run(done(split(2), 1.12, "effect"), split(2), 1.5) is None


def test_not_where_it_does_not_matter_which_run_is_left_out():
    assert ruling_run(done(split(), 1.12), split(), 1.5) is None


def test_not_of_two_runs():
    two = replace(split(1), fit=split(1).fit[:2])
    assert ruling_run(done(two, 1.12), two, 1.5) is None
