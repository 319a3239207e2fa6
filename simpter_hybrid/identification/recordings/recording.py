"""A measured recording: runs of channels in SI units, with what is known about each channel."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import chain
from pathlib import Path

import numpy as np

from ...problems import Problem, Problems
from .agreement import Runs, disagreements, gains_apart, late_speeds
from .at_gaps import as_boundaries, columns_at_gaps
from .between_readings import made_up_rows
from .broken_off import without_broken_off
from .cells import HUGE, check_cells
from .channel_map import ChannelMap
from .checks import Finding, check_run, gap_remarks
from .clipping import clipped_inputs
from .clocks import too_late
from .columns import Columns, Places
from .exchanged import exchanged, hardly_together
from .files import empty_channels
from .filtering import too_fast
from .joined import read_files
from .limits import at_limits
from .lone_samples import lone_sample_remarks
from .lone_speeds import lone_speed_remarks
from .long_ago import from_the_first
from .lost_frames import check_repeated
from .map_file import RecordingMap, read_map
from .marks import with_noise_of_stamps
from .missing_rows import told_left_out
from .motion import Motion, little_motion, motions
from .noise_left import with_noise_left
from .off_axis import off_axis_remarks
from .outliers import check_outliers, reaches
from .recorded_run import RecordedRun, recorded_runs
from .runs import RunSpan, cut_runs
from .speed_ripple import sensors_put_right
from .speed_zero import less_zeros, speed_zeros, zero_remarks
from .stale import stale_inputs, stepped_inputs
from .stamps import evenly_sampled
from .steps import finer_than_told, quieter_than_told
from .stuck import stuck_inputs, stuck_positions
from .text_rows import LISTED
from .told import as_told
from .uneven_noise import uneven_noise_remarks
from .wrapped import unwrapped


@dataclass(frozen=True)
class Recording:
    """All runs of one file or several, and what was found wrong with them.

    Parameters
    ----------
    source : str
        Name of the file as given; of several, that of the first and how many more.
    map : RecordingMap
    runs : tuple of RecordedRun
    findings : tuple of Finding
        What a reader should know: gaps, stuck or saturated sensors, clipped channels.
    absent : tuple of str
        Optional signals that were not recorded.
    still : mapping of str to Motion
        Positions and speeds that hardly move: such data show little.
    places : Places or None
        Where its rows stand; None of one that was not read.
    at_gaps : tuple of str
        Columns that nothing uses, and that change where rows are missing and nowhere else.
    held_out : tuple of str
        Groups of runs that have no part in a search: noise is not estimated from them either.
    """

    source: str
    map: RecordingMap
    runs: tuple[RecordedRun, ...]
    findings: tuple[Finding, ...] = ()
    absent: tuple[str, ...] = ()
    still: Mapping[str, Motion] = field(default_factory=dict)
    places: Places | None = field(default=None, compare=False)
    at_gaps: tuple[str, ...] = ()
    held_out: tuple[str, ...] = ()

    @cached_property
    def noises(self) -> dict[str, float]:
        """Signal -> its noise, as far as `channel_noise` was asked; of no changed recording."""
        return {}

    @property
    def channels(self) -> Mapping[str, ChannelMap]:
        """Signal -> its entry of the map."""
        return self.map.channels

    def grouped(self) -> dict[str, tuple[RecordedRun, ...]]:
        """Group -> its runs, in the order of the file."""
        groups: dict[str, list[RecordedRun]] = {}
        for run in self.runs:
            groups.setdefault(run.group, []).append(run)
        return {name: tuple(runs) for name, runs in groups.items()}


def load_recording(data: str | Path | Sequence[str | Path], map_file: str | Path) -> Recording:
    """Read a recording with its map.

    Parameters
    ----------
    data : path or sequence of paths
        CSV or TSV, also gzipped, or NPZ (one array for each column).  A run ends with its file.
    map_file : path
        TOML map: channel -> signal, unit, sign, offset, clock shift, filter, noise.

    Returns
    -------
    Recording

    Raises
    ------
    InvalidInput
        Everything that makes the recording unusable, at once: columns that are not there, values
        that are no numbers, NaN, time that stands or goes backwards, too few data.
    """
    described, called = as_told(read_map(map_file))
    files = [str(data)] if isinstance(data, (str, Path)) else [str(file) for file in data]
    columns = from_the_first(read_files(files, described), described)
    problems = Problems(columns.places.source)
    runs, short = without_broken_off(_cut(columns, described, problems), columns, described)
    absent = empty_channels(runs, columns, described)
    described = described.without(absent)
    columns = unwrapped(runs, columns, described)
    recorded, findings = _checked(runs, columns, described, problems)
    problems.raise_if_any()
    described = with_noise_left(runs, columns, described)
    described, marked = with_noise_of_stamps(recorded, described)
    recorded, timed = evenly_sampled(recorded, described.channels)
    at_gaps = columns_at_gaps(files, described, recorded, columns)
    parted = as_boundaries(at_gaps) if at_gaps else ""
    missing = [f for r in recorded for f in gap_remarks(r.name, r.row, r.time, parted)]
    known = [(run.time, run.channels) for run in recorded]
    moved, little = _moved(known, described, columns.places, problems)
    zeros = tuple(speed_zeros(known, described.channels))
    apart = gains_apart(less_zeros(known, zeros), described.channels)
    apart += late_speeds(known, described.channels) + zero_remarks(zeros, described.channels)
    apart += hardly_together(known, described.channels, moved)
    apart += stale_inputs(known, described.channels) + stepped_inputs(known, described.channels)
    doubted = _doubted_values(recorded, described.channels)
    recorded, rippled = sensors_put_right(recorded, described.channels)
    waved = off_axis_remarks(recorded, described.channels)
    still = {name: motion for name, motion in moved.items() if motion.little}
    told = (
        *told_left_out(columns),
        *called,
        *little,
        *short,
        *marked,
        *timed,
        *apart,
        *waved,
        *rippled,
        *doubted,
        *missing,
        *findings,
    )
    places = columns.places
    return Recording(
        places.source, described, tuple(recorded), told, absent, still, places, at_gaps
    )


def finding_text(finding: Finding, recording: Recording) -> str:
    """One line for a person."""
    where = finding.where(recording.places or Places((recording.source,)))
    return str(Problem(where, "", finding.what, finding.value, finding.right))


def _cut(columns: Columns, described: RecordingMap, problems: Problems) -> list[RunSpan]:
    """The runs that rows make up; that there is none goes to `problems`."""
    runs = cut_runs(columns, described)
    if not runs:
        right = "rows with a time and a number in every column"
        if described.only:
            right = "runs of which the [only] table of the map leaves some"
        problems.add((), "no run in it", f"{columns.size} rows", right)
    return runs


def _moved(
    known: Runs, described: RecordingMap, places: Places, problems: Problems
) -> tuple[dict[str, Motion], list[Finding]]:
    """Motions, and remarks on little ones; what disagrees, or shows nothing, is refused."""
    _refuse_disagreements(known, described)
    moved = motions(known, described.channels)
    little = little_motion(moved, len(known))
    for finding in little:
        if finding.fatal:
            _refuse(finding, places, problems)
    problems.raise_if_any()
    return moved, little


def _doubted_values(
    recorded: Sequence[RecordedRun], channels: Mapping[str, ChannelMap]
) -> list[Finding]:
    """Of values that were cut off or made up, or that are finer or quieter than was told."""
    return [
        *clipped_inputs(recorded, channels),
        *finer_than_told(recorded, channels),
        *quieter_than_told(recorded, channels),
        *made_up_rows(recorded, channels),
        *lone_sample_remarks(recorded, channels),
        *lone_speed_remarks(recorded, channels),
        *uneven_noise_remarks(recorded, channels),
    ]


def _checked(
    runs: Sequence[RunSpan], columns: Columns, described: RecordingMap, problems: Problems
) -> tuple[list[RecordedRun], list[Finding]]:
    """All runs with what is worth knowing of them; what makes one unusable goes to `problems`."""
    findings = []
    refused: Counter[str] = Counter()
    timed: set[tuple[int, int]] = set()  # whole runs of which a piece was refused for its stamps
    wrong = Problems(described.source)
    too_late(runs, columns, described, wrong)
    too_fast(runs, columns, described, wrong)
    wrong.raise_if_any()
    reach = reaches(runs, columns, described)
    every = recorded_runs(runs, columns, described, reach)
    none = [check_cells(run, columns, described) for run in runs]
    # A filter spreads them over all pieces of a run.
    spread = {run.whole.rows for run, cells in zip(runs, none, strict=True) if cells}
    for run, made, cells in zip(runs, every, none, strict=True):
        channels = _whole(made) if run.whole.rows in spread else made.channels
        found = [*cells, *check_run(made.name, made.row, made.time, channels, described)]
        if not cells:
            found += check_outliers(run, columns, described, reach)
            found += check_repeated(run, columns, described)
            found += stuck_inputs(run, columns, described)
            found += stuck_positions(run, columns, described)
            found += at_limits(run, columns, described)
        for finding in found:
            if not finding.fatal:
                findings.append(finding)
                continue
            if finding.what.startswith("time"):
                if run.whole.rows in timed:
                    continue
                timed.add(run.whole.rows)
            refused[finding.what] += 1
            if refused[finding.what] <= LISTED:
                _refuse(finding, columns.places, problems)
    _refuse_more(refused, problems)
    return every, findings


def _refuse_more(refused: Mapping[str, int], problems: Problems) -> None:
    """How many more runs than are listed are refused, for each reason."""
    for what, count in refused.items():
        if count > LISTED:
            parted = "; do the columns under [runs] change where a run ends, and only there?"
            right = f"none{parted if what.startswith(('time', 'too few')) else ''}"
            problems.add((), f"{what}, in more runs", count - LISTED, right)


def _whole(run: RecordedRun) -> dict[str, np.ndarray]:
    """Channels that can be checked although cells of others hold no number; none without stamps."""
    if not (np.abs(run.time) < HUGE).all():
        return {}
    return {name: v for name, v in run.channels.items() if (np.abs(v) < HUGE).all()}


def _refuse_disagreements(known: Runs, described: RecordingMap) -> None:
    """A speed that is not the rate of its position is a mistake of the map."""
    wrong = Problems(described.source)
    wrongly = (f(known, described.channels) for f in (disagreements, exchanged))
    for signal, what, factor, right in chain.from_iterable(wrongly):
        wrong.add(("channels", signal), what, float(f"{factor:.4g}"), right)
    wrong.raise_if_any()


def _refuse(finding: Finding, places: Places, problems: Problems) -> None:
    where = finding.where(places)
    problems.add((), finding.what, finding.value, finding.right, where=where)
