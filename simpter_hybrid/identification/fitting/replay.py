"""A recorded run as it is replayed: inputs, windows, what is compared and with what weight."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np


@dataclass(frozen=True)
class Observation:
    """One measured channel of one run.

    Parameters
    ----------
    values : ndarray (samples,)
        Mean of the replicates [SI].
    sd : float
        Standard deviation of one replicate's noise [SI].
    keep : ndarray of bool (samples,)
        Samples that are compared.
    weight : float
        Below 1 where neighbouring residuals are not independent (a state restarted from the
        record carries its error along).
    windows : tuple of int
        First samples of windows at whose starts a double integrator was set from the record: the
        straight line in each window's error belongs to that start and is taken away, if `lines`.
    curves : tuple of (ndarray (samples, k), ndarray (k,))
        For each window orthonormal curves along which noisy inputs move a prediction, and the part
        of a residual along them that says nothing.
    lines : bool
        False where a speed is compared: a wrong start moves it by no line.
    step : float
        To which its sensor rounds, where noise does not carry it across [SI]; else 0.
    own : float
        Part of `sd` that the sensor's noise is, where residuals count in larger deviations.
    slopes : tuple of float
        For each window the steepest line that a wrong start may have made [SI a sample]; of a model
        that rests in it what is beyond counts.  Empty: none does, however steep it is.
    """

    values: np.ndarray
    sd: float
    keep: np.ndarray
    weight: float = 1.0
    windows: tuple[int, ...] = ()
    curves: tuple[tuple[np.ndarray, np.ndarray], ...] = ()
    lines: bool = True
    step: float = 0.0
    own: float = 1.0
    slopes: tuple[float, ...] = ()


def beyond_rounding(apart: np.ndarray, step: float) -> np.ndarray:
    """Differences of what was measured and fitted (samples,) that rounding does not explain.

    What was measured is off by up to half a step, and what was fitted to that by as much.
    """
    return np.sign(apart) * np.maximum(np.abs(apart) - step, 0.0)


@dataclass(frozen=True)
class Restart:
    """The motion is set from the record at the start of sample `index` (excitations go on)."""

    index: int
    position: float
    speed: float


@dataclass(frozen=True)
class Breakaway:
    """Observed instant at which a stuck clutch let go.

    Its signed level and the level's standard deviation [N*m], how long it had rested [s], and how
    fast the size of what it transmitted rose before [N*m/s].
    """

    index: int
    level: float
    sd: float
    rested: float = 0.0
    rises: float = 0.0


@dataclass(frozen=True)
class Replay:
    """One run, or the mean of several runs that had the same inputs.

    Parameters
    ----------
    name : str
        For messages, e.g. ``"battery 1 run 3"``.
    experiment : str
        Runs of one experiment had inputs of one kind; split and replicate floor go by it.
    time : ndarray (samples,)
        Time stamps [s].
    inputs : mapping of str to ndarray (samples,)
        What drives the replay [SI]; also run constants, as arrays of one value.
    observed : mapping of str to Observation
    restarts, breakaways : tuples
    replicates : int
        How many runs were averaged.
    drive_is_exact : bool
        Whether all that drives it was told: one replay then serves all runs with these inputs.  No
        two runs have a measured drive or motion in common (`repeats` tells what they differ by).
    own : mapping of str to float
        Factors on parameters of a fit that hold in this run alone, or of a `signed` one what it is
        more there (`own_values`).
    notes : mapping of str to ndarray
        What a rig keeps beside: the measured course, the states of its windows' starts.
    logged : mapping of str to ndarray (samples,)
        Channels that the rig does not read.
    setting : mapping of str to float
        Constants of the run, whether or not the rig reads them.
    added : mapping of str to float
        Parameter of the declared model -> what is known to be more of it in this run [SI].
    followed : tuple of Restart
        Where a trace of force is set anew from the record, if what is compared is not: what a force
        did early would stay in it.
    start_free : bool
        Whether its start is no better known than by all that it shows: it is fitted
        (`rigs.free_start`).
    start_told : tuple of bool
        Whether position and speed of its start are known beforehand, and not read from the record.
    cut_from, piece
        As of `RunSpan`: `name_of_whole` tells which are of one run.
    stamp : float
        Of its first sample [s].
    laid_down : mapping of str to ndarray
        Of a planned run what its experimenter sets, signal -> (samples,); of one that is let go its
        first two samples [SI].
    before : Replay or None
        Piece before this one of the same run, whose rows go on in this one: see `led_in`.
    memo : dict
        What was worked out of its inputs and would be worked out again hundreds of times in a fit;
        each entry holds what it is of.
    """

    name: str
    experiment: str
    time: np.ndarray
    inputs: Mapping[str, np.ndarray]
    observed: Mapping[str, Observation]
    restarts: tuple[Restart, ...] = ()
    breakaways: tuple[Breakaway, ...] = ()
    replicates: int = 1
    drive_is_exact: bool = True
    own: Mapping[str, float] = field(default_factory=dict)
    notes: Mapping[str, np.ndarray] = field(default_factory=dict)
    logged: Mapping[str, np.ndarray] = field(default_factory=dict)
    setting: Mapping[str, float] = field(default_factory=dict)
    added: Mapping[str, float] = field(default_factory=dict)
    followed: tuple[Restart, ...] = ()
    start_free: bool = False
    start_told: tuple[bool, bool] = (False, False)
    cut_from: str = ""
    piece: int = 0
    stamp: float = 0.0
    laid_down: Mapping[str, np.ndarray] = field(default_factory=dict)
    before: Replay | None = None
    memo: dict[tuple, tuple] = field(default_factory=dict, compare=False, repr=False)

    @property
    def compared(self) -> bool:
        """Whether anything of it is compared."""
        return bool(self.breakaways) or any(o.keep.any() for o in self.observed.values())

    @property
    def rows_before(self) -> int:
        """Rows of all pieces before this one of the same run."""
        return 0 if self.before is None else self.before.rows_before + self.before.time.size

    @property
    def led_in(self) -> Replay:
        """This piece with all pieces before it in front, set anew from the record in them.

        Heat, wear, a bent bristle and a part that swings go on where a run is cut; a model that
        remembers them has to be told of what was before.  What is `observed` is the piece's alone;
        numbers that differ from run to run (`own`, `added`) hold in front of it as well.
        """
        if self.before is None:
            return self
        first = self.before.led_in
        k = first.time.size
        later = self.stamp - first.stamp
        start = self.notes.get("start")
        anew = [*(first.restarts or first.followed)]
        anew += [] if start is None else [Restart(k, *map(float, start))]
        notes = dict(_one_after_other(first.notes, self.notes))
        if start is not None:
            notes["start"] = first.notes["start"]
        return replace(
            self, time=np.concatenate([first.time, self.time + later]),
            inputs=dict(_one_after_other(first.inputs, self.inputs)),
            logged=dict(_one_after_other(first.logged, self.logged)), notes=notes,
            restarts=(*anew, *(replace(r, index=r.index + k) for r in self.restarts)),
            followed=(), start_told=first.start_told, stamp=first.stamp, before=None, memo={},
        )  # fmt: skip


def _one_after_other(
    first: Mapping[str, np.ndarray], then: Mapping[str, np.ndarray]
) -> Iterator[tuple[str, np.ndarray]]:
    return ((name, np.concatenate([first[name], then[name]])) for name in then if name in first)


def in_windows(replay: Replay) -> Replay:
    """The run set anew from the record wherever it is `followed`: no error has long to grow.

    A fit to whole runs begins at one to these: a rate that is off turns the later oscillations of a
    whole run upside down, and no small step of it mends them.
    """
    if not replay.followed:
        return replay
    windows = (0, *(r.index for r in replay.followed))
    observed = {
        name: replace(
            seen, windows=windows, slopes=(), curves=(), lines=name.startswith("position")
        )
        for name, seen in replay.observed.items()
    }
    return replace(
        replay, restarts=replay.followed, followed=(), observed=observed, start_free=False
    )


def measured_like(run: Replay, others: Sequence[Replay]) -> Replay:
    """A run whose residuals are measured in the deviations of others'; by the first of a kind."""
    like = {c: seen for other in reversed(others) for c, seen in other.observed.items()}
    seen = {
        c: replace(o, sd=like[c].sd, own=like[c].own) if c in like else o
        for c, o in run.observed.items()
    }
    return replace(run, observed=seen)
