"""On what does a residual depend?  Curves learned on one battery and tested on another.

For each coordinate the residual is described, bin by bin, as ``a + b * torque`` (an added force
and a changed scale).  The curve learned on the fitted battery predicts the residual of the held-out
one; what it takes away there is compared with what it would take away from surrogates that have the
same spectrum (phases random, sign random, run by run) and no dependence.  So a dependence counts
only if it repeats, and coloured noise does not make one.  A coordinate that goes one way in
each of many runs is compared with surrogates of the run and its mirror image: those of the run
alone come back to where they began, so that noise slower than the run is lost from them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from .curve import BINS, FINE, curve_band, learned_curve, on_curve, usual_torque
from .trace import Trace

SURROGATES = 199
#: Runs from which on surrogates last that are slower than a run.  Such a one is itself a drift, and
#: of fewer runs as many of them go all one way as are needed to hide a true one.
SLOW_RUNS = 6


@dataclass(frozen=True)
class Dependence:
    """One coordinate's share of a residual.

    Parameters
    ----------
    coordinate : str
    gain : float
        Relative fall of the held-out sum of squares.
    p_value : float
        Of the surrogates, the share that gains as much (never 0: one over their number plus one).
    samples : int
        Held-out samples (blocks) it was tested on.
    centres : ndarray (bins,)
        Median of the coordinate in each bin [SI].
    added, scaled : ndarray (bins,)
        The curve: residual = added + scaled * torque.
    spread : float
        Standard deviation of the curve over the held-out samples, in units of the residual.
    at : float
        What is usually passed on.
    band : ndarray (bins,), optional
        Half-width of the 95 % band of `curve`, by runs left out in turn.
    """

    coordinate: str
    gain: float
    p_value: float
    samples: int
    centres: np.ndarray
    added: np.ndarray
    scaled: np.ndarray
    spread: float = np.inf
    at: float = 1.0
    band: np.ndarray | None = None

    @property
    def curve(self) -> np.ndarray:
        """The residual in each bin where `at` is passed on (bins,)."""
        return self.added + self.at * self.scaled


def dependences(
    learned: Sequence[Trace], tested: Sequence[Trace], seed: int = 1, together: bool = False
) -> list[Dependence]:
    """Dependence of the residual on every coordinate, largest held-out gain first.

    `together`: a p-value is the share of surrogates in which *some* coordinate gains as much, so
    that many coordinates on few samples do not make a dependence by their number.  Events, which
    are few, are always judged so, by surrogates in which they have changed places: the spectrum of
    a few events is so short that one of a regular test is found again in every fifth surrogate.
    """
    # A run that is shorter than a block of its trace tells nothing.
    learned, tested = ([t for t in traces if t.residual.size] for traces in (learned, tested))
    if not learned or not tested:
        return []
    generator = np.random.default_rng(seed)
    residual = np.concatenate([t.residual for t in tested])
    if all(t.events for t in tested):
        together = True
        surrogates = generator.permuted(np.tile(residual, (SURROGATES, 1)), axis=1)
    else:
        surrogates = _surrogates([t.residual for t in tested], generator)
    total = float(residual @ residual)
    found, most, usual = [], np.full(SURROGATES, -np.inf), usual_torque(learned)
    slow: np.ndarray | None = None
    for name in learned[0].coordinates if total > 0.0 else ():  # a balance without its channels
        best, by_chance = None, np.full(SURROGATES, -np.inf)
        drawn = surrogates
        if not together and len(tested) >= SLOW_RUNS and _goes_one_way(tested, name):
            slow = _slow_surrogates([t.residual for t in tested], seed) if slow is None else slow
            drawn = slow
        for bins in (BINS, FINE) if name in learned[0].local else (BINS,):
            edges, centres, curve = learned_curve(learned, name, bins)
            predicted = np.concatenate(
                [on_curve(edges, curve, t.coordinates[name], t.torque) for t in tested]
            )
            own = float(predicted @ predicted)
            gain = (2 * float(residual @ predicted) - own) / total
            by_chance = np.maximum(by_chance, (2 * (drawn @ predicted) - own) / total)
            if best is None or gain > best.gain:
                told = (centres, curve[:, 0], curve[:, 1], float(np.std(predicted)))
                band = curve_band(learned, name, edges, usual)
                best = Dependence(name, gain, 1.0, residual.size, *told, usual, band)
        assert best is not None
        p_value = (1 + int(np.sum(by_chance >= best.gain))) / (SURROGATES + 1)
        most = np.maximum(most, by_chance)
        found.append(replace(best, p_value=p_value))
    if together:
        found = [
            replace(d, p_value=(1 + int(np.sum(most >= d.gain))) / (SURROGATES + 1)) for d in found
        ]
    return sorted(found, key=lambda d: -d.gain)


def _goes_one_way(traces: Sequence[Trace], name: str) -> bool:
    """Whether a coordinate only rises in every run, or only falls in every run."""
    steps = [np.diff(t.coordinates[name]) for t in traces]
    rise, fall = (all((s * d >= 0.0).all() and d.any() for d in steps) for s in (1.0, -1.0))
    return rise or fall


def _surrogates(series: Sequence[np.ndarray], generator: np.random.Generator) -> np.ndarray:
    return np.concatenate([surrogate(values, SURROGATES, generator) for values in series], axis=1)


def _slow_surrogates(series: Sequence[np.ndarray], seed: int) -> np.ndarray:
    """Surrogates in which what is slower than a series lasts (`SURROGATES`, samples)."""
    generator = np.random.default_rng(seed)
    mirrored = (np.concatenate([values, values[::-1]]) for values in series)
    parts = [surrogate(both, SURROGATES, generator)[:, : both.size // 2] for both in mirrored]
    return np.concatenate(parts, axis=1)


def surrogate(values: np.ndarray, count: int, generator: np.random.Generator) -> np.ndarray:
    """Series of the same spectrum, phases and sign of the mean random (count, samples)."""
    spectrum = np.fft.rfft(values)
    phases = generator.uniform(0, 2 * np.pi, (count, spectrum.size))
    turned = np.abs(spectrum) * np.exp(1j * phases)
    turned[:, 0] = np.abs(spectrum[0]) * generator.choice([-1.0, 1.0], count)
    if values.size % 2 == 0:
        turned[:, -1] = np.abs(spectrum[-1]) * generator.choice([-1.0, 1.0], count)
    return np.fft.irfft(turned, values.size, axis=1)
