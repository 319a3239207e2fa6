"""A damped oscillator that nothing drives, in closed form, and a run of it."""

import numpy as np

from simpter_hybrid.identification.fitting.replay import Observation, Replay

TURN, DECAY, NOISE = 8.7, 0.05, 1e-3
TIME = 0.01 * np.arange(1200)
START = np.array([0.02, -0.11])


def swing(start, turn=TURN):
    """Positions from a start (position, speed)."""
    rate = np.sqrt(turn**2 - DECAY**2)
    fade = np.exp(-DECAY * TIME)
    sine = (start[1] + DECAY * start[0]) / rate
    return fade * (start[0] * np.cos(rate * TIME) + sine * np.sin(rate * TIME))


class Swing:
    """A damped oscillator in closed form."""

    def simulated(self, values, replays):
        return {"position": [swing(r.notes["start"], values["turn"]) for r in replays]}


def swung(start_free=True):
    """A run of it with noise, whose start is known as roughly as rows at its begin tell."""
    seen = swing(START) + NOISE * np.random.default_rng(5).standard_normal(TIME.size)
    observed = {"position": Observation(seen, NOISE, TIME >= 0.0, windows=(0,), lines=False)}
    notes = {"position": seen, "speed": np.gradient(seen, TIME)}
    notes["start"] = START + np.array([2e-3, 0.02])  # as a polynomial had it
    return Replay("run", "run", TIME, {}, observed, notes=notes, start_free=start_free)
