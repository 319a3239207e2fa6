"""What an effect remembers is no merit of it: a servo's integral goes on without one as well."""

from dataclasses import replace

import numpy as np
import pytest
from axis_recordings import MODEL, written

from simpter_hybrid.compiled import simulate
from simpter_hybrid.effects.bias_drift import BiasDrift
from simpter_hybrid.effects.drift import Drift
from simpter_hybrid.effects.wear_in import WearIn
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.replays import axis_replays
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.signals import AxisSignals
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.measuring.sampling import sample

TIME = np.arange(0.0, 8.0, 0.004)
REFERENCE = 0.6 + 0.5 * np.sin(1.1 * TIME)
NOISE = 1e-4
MAP = """
[time]
column = "s"
unit = "s"
[runs]
pieces = 4
[channels.position]
column = "x"
unit = "rad"
sign = 1
role = "measured"
may_rest = true
[channels.reference]
column = "r"
unit = "rad"
sign = 1
role = "input"
"""


def _servo():
    points = ", ".join(
        f'["{t:.3f} s", "{r:.5f} rad"]'
        for t, r in zip(TIME[::5].tolist(), REFERENCE[::5].tolist(), strict=True)
    )
    gains = 'proportional = "6 V/rad"\nderivative = "0.3 V*s/rad"\nintegral_gain = "8 V/(rad*s)"'
    text = MODEL.replace('[["0 s", "0 rad"], ["1 s", "1 rad"]]', f"[{points}]")
    text = text.replace('proportional = "1 V/rad"', gains).replace('"1 V"', '"5 V"')
    return parse(text.replace('t_end = "4 s"', 't_end = "8 s"').replace('["0 rad"]', '["0.6 rad"]'))


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """The declared model, and the pieces of a recording of it with which nothing is wrong."""
    model = _servo()
    q = sample(simulate(model), TIME).q[:, 0]
    q = q + np.random.default_rng(0).normal(0.0, NOISE, TIME.size)
    rows = ["s,x,r"]
    rows += [f"{t:.4f},{a:.6f},{r:.6f}" for t, a, r in zip(TIME, q, REFERENCE, strict=True)]
    written_down = written(tmp_path_factory.mktemp("servo"), rows, MAP)
    return model, axis_replays(written_down, AxisSignals())


def _off(model, pieces):
    predictor = ScenarioPredictor(model, AxisRig(servo=True))
    told = predictor.predict({p.name: p.value for p in predictor.parameters}, pieces)["position"]
    seen = [r.observed["position"].values for r in pieces]
    return [float(np.std(a - b)) for a, b in zip(seen, told, strict=True)]


def test_the_servo_goes_on_from_piece_to_piece(recorded):
    # Starts that are set from the record are off by about as much as noise.
    assert max(_off(*recorded)) < 4.0 * NOISE
    model, pieces = recorded
    assert max(_off(model, [replace(r, before=None) for r in pieces])) > 20.0 * NOISE


@pytest.mark.parametrize(
    "nothing",
    [
        Drift(clutch=0, rate_per_time=0.0),
        BiasDrift(coordinate=0, bias=0.0, rate=0.0),
        WearIn(clutch=0, change=0.0),
    ],
    ids=lambda effect: type(effect).__name__,
)
def test_it_does(recorded, nothing):
    model, pieces = recorded
    with_it = _off(replace(model, effects=(nothing,)), pieces)
    assert with_it == pytest.approx(_off(model, pieces), rel=0.01)
