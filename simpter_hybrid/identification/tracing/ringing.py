"""Does a torque ring after breakaway?  The spectrum of windows after each, over that elsewhere.

What rings has no mean, so no curve over a coordinate shows it, and what it adds to the error of
whole runs may be nothing; its line stands far above what noise and wrong instants do.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.special import gammaincc

from .signature import Dependence
from .trace import Trace

#: Balance of the spectra, and the event after which they are taken.
RINGING, BREAKAWAY = "ringing", "breakaway"
#: Length of a window [s], and what is left out before it: an instant that is wrong is a jump.
WINDOW, AFTER = 0.25, 0.02
#: Lines of the spectrum left out: what is slower than a window is no line.
SLOW = 2
#: Part by which clocks of the same rate differ at most.
CLOCK = 5e-3
#: Fewest windows after breakaways on either side.
FEWEST = 5


def ringing_trace(residual: np.ndarray, step: float, starts: Sequence[int]) -> Trace | None:
    """Spectra of one run: ``residual`` after its breakaways, ``torque`` as elsewhere in the run.

    Parameters
    ----------
    residual : ndarray (samples,)
        Residual torque, sample by sample [N*m].
    step : float
        Sample interval [s].
    starts : sequence of int
        Samples at which it broke away.

    Returns
    -------
    Trace or None
        Over frequency [Hz], summed over the breakaways, which ``windows`` counts; None where the
        run has no whole window after a breakaway or none elsewhere.
    """
    size, skipped = round(WINDOW / step), round(AFTER / step)
    if size < 4 * SLOW:
        return None
    after, taken = [], np.zeros(residual.size, bool)
    for start in starts:
        part = slice(start + skipped, start + skipped + size)
        taken[start : part.stop] = True
        alone = not any(start < other < part.stop for other in starts)  # else another jump is in it
        if alone and residual[part].size == size and np.any(residual[part]):
            after.append(_power(residual[part]))
    begins = range(0, residual.size - size, size // 2)
    free = [slice(b, b + size) for b in begins if not taken[b : b + size].any()]
    elsewhere = [_power(residual[part]) for part in free if np.any(residual[part])]
    if not after or not elsewhere:
        return None
    frequency = np.fft.rfftfreq(size, step)[SLOW:]
    expected = len(after) * np.mean(elsewhere, axis=0)
    counted = np.full(frequency.size, float(len(after)))
    return Trace(np.sum(after, axis=0), expected, {BREAKAWAY: frequency, "windows": counted})


def ringing(learned: Sequence[Trace], tested: Sequence[Trace]) -> Dependence | None:
    """The line that stands out after breakaways, found on some runs and tested on others.

    Returns
    -------
    Dependence or None
        ``gain``: part of the tested power at that line which the rest of the spectrum does not
        tell.  ``centres``: frequency [Hz], ``added``: tested power over that elsewhere, as a
        multiple of its median, ``scaled``: the learned one.  The line is the largest learned; a
        spectrum that is largest at its slow end has a slope (a step, a creeping) and no line.  Of
        runs sampled at several rates those of most windows are asked.
    """
    learned, tested = max(
        ([[t for t in some if _alike(t, one)] for some in (learned, tested)] for one in learned),
        key=lambda both: min(map(_windows, both)),
        default=([], []),
    )  # spectra of other rates have other lines
    if min(_windows(learned), _windows(tested)) < FEWEST:
        return None
    frequency = learned[0].coordinates[BREAKAWAY]
    before, excess, count = _excess(learned), _excess(tested), _windows(tested)
    k = int(np.argmax(before))
    if k == 0 or not np.isfinite(before).all() or not np.isfinite(excess).all():
        return None
    if excess[:k].min() >= excess[k]:  # tested, nothing slower is below it: a slope, no line
        return None
    p_value = float(gammaincc(count, count * excess[k]))
    gain = 1.0 - 1.0 / max(float(excess[k]), 1e-9)
    return Dependence(BREAKAWAY, gain, p_value, count, frequency, excess, before)


def line(found: Dependence) -> tuple[float, float]:
    """Frequency of the line [Hz], and by how much it stands out of the tested spectrum."""
    return line_of(found.centres, found.added, found.scaled)


def line_of(
    centres: Sequence[float] | np.ndarray,
    added: Sequence[float] | np.ndarray,
    scaled: Sequence[float] | np.ndarray,
) -> tuple[float, float]:
    """The same of the numbers of a dependence alone."""
    k = int(np.argmax(scaled))
    return float(centres[k]), float(added[k])


def _power(values: np.ndarray) -> np.ndarray:
    tapered = (values - values.mean()) * np.hanning(values.size)
    return np.abs(np.fft.rfft(tapered))[SLOW:] ** 2


def _alike(one: Trace, other: Trace) -> bool:
    """Whether two spectra have the same lines, but for what a clock's jitter moves them."""
    lines = one.coordinates[BREAKAWAY], other.coordinates[BREAKAWAY]
    return lines[0].size == lines[1].size and np.allclose(*lines, rtol=CLOCK, atol=0.0)


def _windows(traces: Sequence[Trace]) -> int:
    return round(sum(float(t.coordinates["windows"][0]) for t in traces))


def _excess(traces: Sequence[Trace]) -> np.ndarray:
    after = np.sum([t.residual for t in traces], axis=0)
    elsewhere = np.sum([t.torque for t in traces], axis=0)
    with np.errstate(divide="ignore", invalid="ignore"):  # a residual without noise has no spectrum
        ratio = after / elsewhere
        return ratio / np.median(ratio)
