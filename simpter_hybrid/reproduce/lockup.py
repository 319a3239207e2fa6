"""S57: a single sinusoid of the proper frequency locks the tip."""

from __future__ import annotations

import functools

import numpy as np

from ..rigs.inputs import nominal
from ..rigs.line import line
from ..sampling import sample
from .rows import Engine, Row, claim

#: Frequencies of the sweep [Hz] and feedback gains [V/(lb-in)].
FREQUENCIES = tuple(float(f) for f in np.geomspace(0.3, 6.0, 14))
PHASES = (0.0, 1.5708, 3.1416, 4.7124)


@functools.lru_cache(maxsize=256)
def progress(
    engine: Engine, kind: str, gain: float, frequency: float, phase: float
) -> tuple[bool, float, float]:
    """Whether the tip arrives within 12 s; share of time locked; when it last began to be [s]."""
    inputs = nominal().replace(frequencies=(frequency,), phases=(phase,))
    trajectory = engine(line(kind, gain, inputs))
    times = np.arange(int(trajectory.t_end / 0.01)) * 0.01
    stuck = sample(trajectory, times).mode == 0
    locked = stuck.sum(axis=1) >= 2
    moving = np.flatnonzero(~locked)
    last = float(times[moving[-1]]) if len(moving) else 0.0
    return trajectory.status == "stopped", float(locked.mean()), last


def lockup(engine: Engine) -> list[Row]:
    """Single sinusoids of 5 lb over frequency and phase, for each of Table 6's controllers."""
    rows = []
    for words, kind, gain in (
        ("baseline", "impedance", 0.0),
        ("impedance with feedback", "impedance", 0.16),
        ("velocity control", "velocity", 0.16),
    ):
        runs = {(f, p): progress(engine, kind, gain, f, p) for f in FREQUENCIES for p in PHASES}
        never = [key for key, (arrived, _, _) in runs.items() if not arrived]
        forever = [key for key in never if runs[key][2] < 11.0]
        text = ", ".join(sorted({f"{f:.2f} Hz" for f, _ in never}, key=lambda s: float(s[:-3])))
        rows.append(
            claim(
                "S57",
                f"a single sinusoid of the proper frequency keeps the tip from moving ({words})",
                "has been observed",
                f"of {len(runs)} runs {len(never)} do not arrive within 12 s"
                + (f" ({text})" if never else "")
                + f"; {len(forever)} of them are locked for good; longest share of time locked "
                f"{100 * max(r[1] for r in runs.values()):.0f} %",
                bool(never),
                not_arrived=len(never),
                locked_for_good=len(forever),
            )
        )
    return rows
