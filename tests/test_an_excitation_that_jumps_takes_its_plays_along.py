"""A clutch without lag: its excitation is never between two commands, and its memory keeps up."""

import numpy as np
import pytest
from devices_for_tests import Coulomb, RecordedCommands

from simpter_hybrid import compiled, engine
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effects.play_hysteresis import PlayHysteresis
from simpter_hybrid.effects.remanence import Remanence
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.scenario import Scenario

HELD = 0.01
#: A measured current: steps, and noise that moves it all the time.
COMMANDS = tuple(
    float(abs(x))
    for x in np.repeat([4.0, 1.0, 3.0, 2.5, 3.5, 0.5], 5)
    + np.random.default_rng(1).normal(0.0, 0.05, 30)
)


def torques(effect, simulate):
    """Torque in the middle of each held command: 1 N m a volt that acts."""
    clutch = Clutch(Coulomb(1.0, 1.0), time_constant=0.0, delay=0.0, threshold=-1.0)
    run = Scenario("jumps", Testbed(1e6), (clutch,), (0.0,), (5.0,), HELD * len(COMMANDS))
    run = run.replace(
        effects=(effect,), controllers=((RecordedCommands(1.0), 1),), period=HELD,
        rec=(*COMMANDS, 0.0), command=(0.0,), excitation=(0.0,),
    )  # fmt: skip
    times = HELD * (np.arange(len(COMMANDS)) + 0.5)
    return -sample(simulate(run), times).tau[:, 0]


@pytest.mark.parametrize(
    "simulate", [engine.simulate, compiled.simulate], ids=["scipy", "compiled"]
)
@pytest.mark.parametrize(
    ("effect", "share", "widths"),
    [
        (PlayHysteresis(clutch=0, share=0.6, width=0.9), 0.6, (0.3, 0.6, 0.9)),
        (Remanence(clutch=0, width=0.3), 1.0, (0.3,)),
    ],
    ids=["plays", "remanence"],
)
def test_it_equals_plays_stepped_through_the_commands(simulate, effect, share, widths):
    memory, expected = np.zeros(len(widths)), []
    for value in COMMANDS:
        memory = np.clip(memory, value - np.array(widths), value + np.array(widths))
        expected.append(max(0.0, (1.0 - share) * value + share * memory.mean()))
    assert torques(effect, simulate) == pytest.approx(np.array(expected), abs=1e-9)
