"""A rig small enough to be solved by hand: torque = scale * u + gain * x + ..."""

from dataclasses import dataclass

import numpy as np

from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.replay import Observation, Replay
from simpter_hybrid.identification.tracing.trace import Trace

SCALE = Parameter("scale", 1.0, 0.5, 1.5, 0.01, tolerance=0.5)
ALONG_X = Candidate(
    "along x",
    (Parameter("gain", 0.0, -5.0, 5.0, 0.05),),
    ((0.1,),),
    "x",
    "friction",
    ("friction:x",),
)
ALONG_Y = Candidate(
    "along y",
    (Parameter("other", 0.0, -5.0, 5.0, 0.05),),
    ((0.1,),),
    "y",
    "friction",
    ("friction:y",),
)
#: Parameters, and the inputs that they multiply; a run needs ``z`` only for what leans on it.
TERMS = (("scale", "u"), ("gain", "x"), ("other", "y"), ("lean", "z"))


@dataclass(frozen=True)
class ToyRig:
    """Implements the predictor protocol."""

    parameters: tuple[Parameter, ...] = (SCALE,)

    def extended(self, candidate: Candidate) -> "ToyRig":
        return type(self)((*self.parameters, *candidate.parameters))

    def combines(self, candidate: Candidate) -> bool:
        return True

    def predict(self, values, replays):
        terms = [(p, c) for p, c in TERMS if p in values]
        return {
            "torque": [
                sum((values[p] * r.inputs[c] for p, c in terms), np.zeros(r.time.size))
                for r in replays
            ]
        }


def toy_replay(name, seed, scale=1.0, gain=0.0, noise=0.1, samples=2000, experiment="a") -> Replay:
    """A run whose inputs depend on the experiment and whose noise depends on the seed."""
    time = np.arange(samples) * 0.01
    drawn = np.random.default_rng(sum(map(ord, experiment)))
    inputs = {
        "u": 1.0 + 0.5 * np.sin(time),
        "x": np.sin(2.3 * time + drawn.uniform(0, 6)),
        "y": np.cos(5.1 * time + drawn.uniform(0, 6)),
    }
    values = scale * inputs["u"] + gain * inputs["x"]
    values = values + noise * np.random.default_rng(seed).standard_normal(samples)
    seen = Observation(values, noise, np.ones(samples, bool))
    return Replay(name, experiment, time, inputs, {"torque": seen})


def tracer(predictor, values, replays):
    """One balance along x, y and u."""
    predicted = predictor.predict(values, replays)["torque"]
    return {
        "friction": [
            Trace(
                r.observed["torque"].values - p,
                p,
                {"x": r.inputs["x"], "y": r.inputs["y"], "u": r.inputs["u"]},
            ).thinned(2)
            for r, p in zip(replays, predicted, strict=True)
        ]
    }
