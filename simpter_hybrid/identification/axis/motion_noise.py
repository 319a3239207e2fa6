"""What noise of a motion that a tester prescribes does to the force that it takes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from ..fitting.replay import Replay
from ..recordings.recording import Recording
from ..rigs.input_noise import InputNoise
from ..rigs.scenario_predictor import ScenarioPredictor
from .prescribed_replays import CLEARER, prescribed_replays


@dataclass(frozen=True)
class MotionNoise(InputNoise):
    """Noise of a prescribed motion, drawn once for every seed and kept.

    All models and parts get the same draws: a motion is not smoothed anew for each.

    Parameters
    ----------
    drawn : dict
        Seed -> recording, and its replays.
    """

    drawn: dict[int, tuple[Recording, Sequence[Replay]]] = field(default_factory=dict)

    def again(self, seed: int) -> Sequence[Replay]:
        """The replays of all runs with that noise."""
        recording, replays = self.drawn.get(seed, (None, ()))
        if recording is not self.recording:
            replays = super().again(seed)
            self.drawn[seed] = self.recording, replays
        return replays


def motion_noise(recording: Recording, predictor: ScenarioPredictor, inertia: float) -> MotionNoise:
    """Noise of the recorded motion, simulated as far as it bends bristles and springs.

    What it does to the force of inertia, and what noise of a pressure does to a piston's, is
    already in the deviations of the observed force.
    """
    known = prescribed_replays(recording, inertia=inertia)

    def made(other: Recording) -> list[Replay]:
        again = prescribed_replays(other, inertia=inertia)
        kept = ("acceleration", CLEARER)
        return [
            replace(k, notes={**r.notes, **{name: k.notes[name] for name in kept}})
            for r, k in zip(again, known, strict=True)
        ]

    return MotionNoise(predictor, recording, made)
