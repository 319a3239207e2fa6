"""A number far above the true one is in another valley: no small step lowers the error there."""

from dataclasses import dataclass, replace
from types import SimpleNamespace as Some

import numpy as np
import pytest
from toy_rig import SCALE, toy_replay

from simpter_hybrid.identification.far_off import far_off
from simpter_hybrid.identification.first_refit import first_refit
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.predictor import Parameter

TRUE, DECLARED = 2.7, 4.5


@dataclass(frozen=True)
class Swinging:
    """torque = scale u + 2 exp(-t / 2) sin(frequency t)."""

    parameters: tuple[Parameter, ...]

    def extended(self, candidate):
        own = {p.name: p for p in (*self.parameters, *candidate.parameters)}
        return Swinging(tuple(own.values()))

    def scenario(self, values):
        return None

    def predict(self, values, replays):
        return {
            "torque": [values["scale"] * r.inputs["u"] + swing(r, values["f"]) for r in replays]
        }


def swing(replay, frequency):
    return 2.0 * np.exp(-0.5 * replay.time) * np.sin(frequency * replay.time)


def run(seed):
    replay = toy_replay("run", seed)
    replay.observed["torque"].values[:] += swing(replay, TRUE)
    return replay


def swinging(relative):
    lower, upper = (DECLARED * (1.0 - 0.9 * relative), DECLARED * (1.0 + 3.5 * relative))
    frequency = Parameter("f", DECLARED, lower, upper, 0.02, tolerance=relative * DECLARED)
    return Swinging((SCALE, frequency))


def test_it_is_found_within_its_tolerance():
    fit = first_refit(swinging(0.6), [run(1), run(2)], {"scale": SCALE.value, "f": DECLARED})
    assert fit.values["f"] == pytest.approx(TRUE, abs=0.05)  # a rough fit


def test_beyond_its_tolerance_it_is_asked_about(monkeypatch):
    module = "simpter_hybrid.identification.far_off"
    monkeypatch.setattr(f"{module}.validate", lambda scenario: None)
    monkeypatch.setattr(f"{module}._moved_untold", lambda predictor: ())  # of no scenario
    narrow, split = swinging(0.1), Split([run(1), run(2)], [run(3)], [])
    model = refitted(narrow, split)
    led_astray = replace(model, values={**model.values, "scale": 0.3})
    done = Some(refitted=led_astray, corrected=led_astray, verdict=Some(kind="unknown"))
    off = far_off(done, split, 1.0)
    assert off.name == "f"
    assert off.times == pytest.approx(TRUE / DECLARED, rel=0.01)
