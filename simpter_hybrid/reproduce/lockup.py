"""S57: a single sinusoid of the proper frequency locks the tip."""

from __future__ import annotations

import functools
from dataclasses import dataclass

import numpy as np

from ..known_units import INCH
from ..measuring.sampling import sample
from ..rigs.inputs import Inputs, drawn, nominal
from ..rigs.line import line
from .rows import Engine, Row, claim
from .standard import CONTROLLERS

#: Frequencies [Hz] and phases [rad] of the sweep, and the rates of the controller [Hz].
FREQUENCIES = tuple(float(f) for f in np.geomspace(0.3, 6.0, 14))
PHASES = (0.0, 1.5708, 3.1416, 4.7124)
RATES = (30.0, 150.0)


@dataclass(frozen=True)
class Progress:
    """How a run went: arrival within 12 s, path in its second half [in]."""

    arrived: bool
    late_path: float

    @property
    def halted(self) -> bool:
        """Whether the tip has come to rest for good: less than 0.1 in in the last six seconds."""
        return not self.arrived and self.late_path < 0.1


def progress(engine: Engine, kind: str, gain: float, inputs: Inputs) -> Progress:
    """Run with one torque selector and feedback gain."""
    trajectory = engine(line(kind, gain, inputs))
    times = np.arange(int(trajectory.t_end / 0.02)) * 0.02
    found = sample(trajectory, times)
    late = found.tip[len(times) // 2 :]
    path = float(np.hypot(*np.diff(late, axis=0).T).sum()) / INCH
    return Progress(trajectory.status == "stopped", path)


@functools.lru_cache(maxsize=16)
def swept(engine: Engine, name: str, rate: float) -> list[tuple[float, Progress]]:
    """Frequency and progress for every frequency and phase."""
    kind, gain = CONTROLLERS[name]
    found = []
    for frequency in FREQUENCIES:
        for phase in PHASES:
            inputs = nominal().replace(frequencies=(frequency,), phases=(phase,), rate=rate)
            found.append((frequency, progress(engine, kind, gain, inputs)))
    return found


def single(inputs: Inputs) -> Inputs:
    """The inputs with the first sinusoid alone, at the whole normal force."""
    return inputs.replace(frequencies=inputs.frequencies[:1], phases=inputs.phases[:1])


def went(runs: list[tuple[float, Progress]]) -> str:
    """How many runs arrive, come to rest and creep, with the frequencies of those that creep."""
    resting = sum(run.halted for _, run in runs)
    late = [(f, run) for f, run in runs if not run.arrived and not run.halted]
    if resting + len(late) == 0:
        return f"all of {len(runs)} runs arrive"
    words = f"{resting} of {len(runs)} runs come to rest and {len(late)} creep"
    if not late:
        return words
    creep = ", ".join(f"{f:.2f} Hz" for f in sorted({f for f, _ in late}))
    return f"{words} ({creep}, {min(run.late_path for _, run in late):.1f} in in 6 s)"


def lockup(engine: Engine, draws: int = 32) -> list[Row]:
    """Single sinusoids of 5 lb over frequency and phase, then over the plausible inputs."""
    plausible = [single(inputs) for inputs in drawn(draws, seed=57)]
    rows = []
    for name, (kind, gain) in CONTROLLERS.items():
        parts, halted = [], 0
        for rate in RATES:
            runs = swept(engine, name, rate)
            halted += sum(run.halted for _, run in runs)
            parts.append(f"at {rate:g} Hz {went(runs)}")
        drawn_halted = [progress(engine, kind, gain, inputs).halted for inputs in plausible]
        resting = sum(drawn_halted)
        rows.append(
            claim(
                "S57",
                f"a single sinusoid of the proper frequency keeps the tip from moving ({name})",
                "has been observed",
                f"{'; '.join(parts)}; the tip rests with {resting} of {draws} plausible inputs, "
                "each with its first sinusoid alone",
                halted > 0 or resting > 0,
                why="the translator is taken not to ask a clutch at rest, which lets go at the "
                "next "
                "sample; the thesis prints neither that rule nor the frequency. Creeping runs do "
                "not arrive within 12 s, with some clutch stuck half of the time",
            )
        )
    return rows
