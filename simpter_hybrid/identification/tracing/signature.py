"""On what does a residual depend?  Curves learned on one battery and tested on another.

For each coordinate the residual is described, bin by bin, as ``a + b * torque`` (an added force
and a changed scale).  The curve learned on the fitted battery predicts the residual of the held-out
one; what it takes away there is compared with what it would take away from surrogates that have the
same spectrum (phases random, sign random, run by run) and no dependence.  So a dependence counts
only if it repeats, and coloured noise does not make one.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

BINS = 12
#: Fewest learned samples in a bin.
FEWEST = 8
SURROGATES = 199
#: Samples are averaged in blocks of this length [s]; the noise of neighbours is then nearly white.
BLOCK = 0.01
#: Missing forces beyond this many standard deviations are instants, not dependences.
BOUND = 6.0
#: A coordinate with less than this share of its variance within runs stays where it is in them.
MOVES = 0.1
#: Of a signal that one offset and one scale do but for this part nothing is asked.
SCALED = 0.2


@dataclass(frozen=True)
class Trace:
    """Residual of one run and the coordinates along it, all (samples,).

    `events`: the samples are events whose errors do not go on from one to the next; by chance they
    might have come in any other order.
    """

    residual: np.ndarray
    torque: np.ndarray
    coordinates: Mapping[str, np.ndarray]
    events: bool = False

    def thinned(self, samples: int) -> Trace:
        """Means over blocks of `samples`; coordinates at the middle of each block."""
        count = self.residual.size // samples
        middle = np.arange(count) * samples + samples // 2
        chosen = {name: values[middle] for name, values in self.coordinates.items()}
        return Trace(_block(self.residual, samples), _block(self.torque, samples), chosen)


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
    """

    coordinate: str
    gain: float
    p_value: float
    samples: int
    centres: np.ndarray
    added: np.ndarray
    scaled: np.ndarray
    spread: float = np.inf


def dependences(
    learned: Sequence[Trace], tested: Sequence[Trace], seed: int = 1, together: bool = False
) -> list[Dependence]:
    """Dependence of the residual on every coordinate, largest held-out gain first.

    `together`: a p-value is the share of surrogates in which *some* coordinate gains as much, so
    that many coordinates on few samples do not make a dependence by their number.  Events, which
    are few, are always judged so, by surrogates in which they have changed places: the spectrum of
    a few events is so short that one of a regular test is found again in every fifth surrogate.
    """
    generator = np.random.default_rng(seed)
    residual = np.concatenate([t.residual for t in tested])
    if all(t.events for t in tested):
        together = True
        surrogates = generator.permuted(np.tile(residual, (SURROGATES, 1)), axis=1)
    else:
        surrogates = np.concatenate(
            [surrogate(t.residual, SURROGATES, generator) for t in tested], axis=1
        )
    total = float(residual @ residual)
    found, most = [], np.full(SURROGATES, -np.inf)
    for name in learned[0].coordinates if total > 0.0 else ():  # a balance without its channels
        edges, centres, curve = _learn(learned, name)
        predicted = np.concatenate(
            [_apply(edges, curve, t.coordinates[name], t.torque) for t in tested]
        )
        own = float(predicted @ predicted)
        gain = (2 * float(residual @ predicted) - own) / total
        chance = (2 * (surrogates @ predicted) - own) / total
        p_value = (1 + int(np.sum(chance >= gain))) / (SURROGATES + 1)
        most = np.maximum(most, chance)
        told = (centres, curve[:, 0], curve[:, 1], float(np.std(predicted)))
        found.append(Dependence(name, gain, p_value, residual.size, *told))
    if together:
        found = [
            replace(d, p_value=(1 + int(np.sum(most >= d.gain))) / (SURROGATES + 1)) for d in found
        ]
    return sorted(found, key=lambda d: -d.gain)


def imitated(learned: Sequence[Trace], tested: Sequence[Trace], names: Sequence[str]) -> dict:
    """Part of a signal, held out, that a curve in each of `names` takes away.

    Beyond what one offset and one scale do, which are curves in any coordinate; nothing is said
    where these do most of it.
    """
    whole = float(sum(t.residual @ t.residual for t in tested))
    learned, tested = _beyond_scale(learned, tested)
    signal = np.concatenate([t.residual for t in tested])
    total = float(signal @ signal)
    found = {}
    for name in names if total > SCALED * whole else ():
        edges, _, curve = _learn(learned, name)
        told = [_apply(edges, curve, t.coordinates[name], t.torque) for t in tested]
        left = signal - np.concatenate(told)
        found[name] = 1.0 - float(left @ left) / total
    return found


def _beyond_scale(learned: Sequence[Trace], tested: Sequence[Trace]):
    """Residuals less the offset and the scale learned on the first."""
    torque = np.concatenate([t.torque for t in learned])
    signal = np.concatenate([t.residual for t in learned])
    columns = np.column_stack([np.ones(torque.size), torque])
    offset, scale = np.linalg.lstsq(columns, signal, rcond=None)[0]
    return tuple(
        [replace(t, residual=t.residual - offset - scale * t.torque) for t in traces]
        for traces in (learned, tested)
    )


def imitated_by_runs(tested: Sequence[Trace], own: Sequence[str]) -> float:
    """Part of a signal that an offset and a scale of each run take away; 0 if `own` move in runs.

    A coordinate that stays where it is in every run differs between runs as anything else may (a
    temperature, a wear, a gain), so a dependence on it alone carries no name.
    """
    signal = np.concatenate([t.residual for t in tested])
    total = float(signal @ signal)
    if total == 0.0 or not own or max(_moves(tested, name) for name in own) > MOVES:
        return 0.0
    left = 0.0
    for t in tested:
        columns = np.column_stack([np.ones(t.torque.size), t.torque])
        rest = t.residual - columns @ np.linalg.lstsq(columns, t.residual, rcond=None)[0]
        left += float(rest @ rest)
    return 1.0 - left / total


def _moves(traces: Sequence[Trace], name: str) -> float:
    """Share of a coordinate's variance that lies within runs, where the signal is."""
    x = [t.coordinates[name] for t in traces]
    weights = [t.residual**2 for t in traces]
    mass = np.array([w.sum() for w in weights])
    kept = [k for k in range(len(x)) if mass[k] > 0.0]
    means = np.array([float(weights[k] @ x[k]) / mass[k] for k in kept])
    share = mass[kept] / mass.sum()
    within = sum(float(weights[k] @ (x[k] - m) ** 2) for k, m in zip(kept, means, strict=True))
    within /= float(mass.sum())
    between = float(share @ (means - share @ means) ** 2)
    return within / (within + between) if within + between > 0.0 else 1.0


def surrogate(values: np.ndarray, count: int, generator: np.random.Generator) -> np.ndarray:
    """Series of the same spectrum, phases and sign of the mean random (count, samples)."""
    spectrum = np.fft.rfft(values)
    phases = generator.uniform(0, 2 * np.pi, (count, spectrum.size))
    turned = np.abs(spectrum) * np.exp(1j * phases)
    turned[:, 0] = np.abs(spectrum[0]) * generator.choice([-1.0, 1.0], count)
    if values.size % 2 == 0:
        turned[:, -1] = np.abs(spectrum[-1]) * generator.choice([-1.0, 1.0], count)
    return np.fft.irfft(turned, values.size, axis=1)


def _learn(traces: Sequence[Trace], name: str):
    """Quantile bins and, in each, the least-squares a + b*torque."""
    x = np.concatenate([t.coordinates[name] for t in traces])
    y = np.concatenate([t.residual for t in traces])
    torque = np.concatenate([t.torque for t in traces])
    edges = _edges(x)
    place = np.searchsorted(edges, x, side="right")
    ridge = 1e-3 * (float(torque @ torque) / torque.size + 1e-30)
    centres, curve = [], []
    for k in range(edges.size + 1):
        chosen = place == k
        t, r = torque[chosen], y[chosen]
        n = max(t.size, 1)
        normal = np.array([[n, t.sum()], [t.sum(), t @ t + n * ridge]])
        curve.append(np.linalg.solve(normal, [r.sum(), t @ r]))
        centres.append(float(np.median(x[chosen])) if t.size else np.nan)
    return edges, np.array(centres), np.array(curve)


def _edges(x: np.ndarray) -> np.ndarray:
    """Edges of bins of equally many samples, or between values that are few (a direction)."""
    bins = max(2, min(BINS, x.size // FEWEST))
    values = np.unique(x)
    if values.size <= max(bins, 3):
        return (values[1:] + values[:-1]) / 2
    return np.unique(np.quantile(x, np.linspace(0, 1, bins + 1)))[1:-1]


def _apply(edges, curve, x, torque):
    place = np.searchsorted(edges, x, side="right")
    return curve[place, 0] + curve[place, 1] * torque


def _block(values: np.ndarray, samples: int) -> np.ndarray:
    count = values.size // samples
    return values[: count * samples].reshape(count, samples).mean(axis=1)


def force_trace(
    missing: np.ndarray,
    passed: np.ndarray,
    along: Mapping[str, np.ndarray],
    step: float,
    block: float = BLOCK,
) -> Trace:
    """A trace of a missing force: instants cut to size, then averaged over blocks.

    Parameters
    ----------
    missing, passed : ndarray (samples,)
        Missing force, and the force that goes through the friction [N or N m].
    along : mapping of str to ndarray (samples,)
        Coordinates on which it may depend.
    step, block : float
        Sample interval and length of a block [s].
    """
    bound = BOUND * float(np.std(missing)) + 1e-30
    trace = Trace(np.clip(missing, -bound, bound), passed, along)
    return trace.thinned(max(1, round(block / step)))
