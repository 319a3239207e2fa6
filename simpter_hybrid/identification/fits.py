"""Whether a recording, its map and a model go together."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from ..problems import InvalidInput, Problem, Problems, together
from ..reading.reader import one_of
from ..scenario import Scenario
from .axis.joints_rig import JointSignals, of_joints
from .axis.prescribed_replays import PrescribedSignals
from .axis.signals import AxisSignals
from .fitting_map import check_axis
from .known_of_runs import check_known
from .played_rate import check_rate, check_ticks
from .recordings.checks import Finding
from .recordings.recording import Recording
from .rigs.bench import Bench
from .rotor.signals import RotorSignals
from .tip.rig import TipSignals

#: What is said of an axis whose position is an input and of which no force is measured.
MOVED = (
    "a channel of that name: what a tester measures, force or torque, of an axis that it moves "
    '(if a drive moves it, its position has role = "measured")'
)


def check_fits(recording: Recording, declared: Scenario) -> None:
    """Check that this model may be held against this recording.

    Raises
    ------
    InvalidInput
        With all that keeps it from that.
    """
    together(
        lambda: check_tolerances(declared),
        lambda: check_known(recording, declared),
        lambda: _check_rig(recording, declared),
    )


def check_any_compared(bench: Bench, recording: Recording) -> None:
    """Check that of every part (fit, select, report) something is compared.

    Raises
    ------
    InvalidInput
        With each part of which nothing is.
    """
    problems = Problems(recording.source)
    for part, replays in bench.parts.items():
        if not any(r.compared for r in replays):
            what, got = f"nothing of the runs that {part} can be compared", f"{len(replays)} runs"
            right = "longer runs, or ones that begin at rest; another split of the runs in the map"
            problems.add((), what, got, right)
    problems.raise_if_any()


def nothing_compared(bench: Bench, recording: Recording) -> tuple[Finding, ...]:
    """Remarks on runs of which no row counts: too short, or too quick for what they are told by."""
    rows = {run.name: run.rows[0] for run in recording.runs}
    what, right = "nothing of this run is compared", "a longer or a slower run, or finer rows"
    every = {r.name: r for replays in bench.parts.values() for r in replays if not r.compared}
    return tuple(
        Finding(name, what, f"{r.time.size} rows", right, rows.get(name, -1), r.stamp)
        for name, r in every.items()
    )


def _check_rig(recording: Recording, declared: Scenario) -> None:
    """Check that the rig's signals are there, and that map and rate go with the model."""
    there = recording.channels
    if TipSignals().force[0] in there:
        needed = (*TipSignals().of(declared.device), *there)
        check_signals(recording, tuple(dict.fromkeys(needed)))
        check_ticks(recording, declared)
    elif RotorSignals().transmitted in there:
        s = RotorSignals()
        check_signals(recording, (s.speed, s.position, s.command, s.inputs[0], s.prescribed))
        check_rate(recording, declared)
    elif of_joints(recording):
        right = "a channel of that name; of a joint that no motor drives, zeros and a motor's model"
        joints = JointSignals()
        drives = [name for name in joints.used(recording) if name.startswith(joints.drive)]
        others = dict.fromkeys((*joints.used(recording), *there))
        together(
            lambda: check_signals(recording, tuple(n for n in others if n not in drives)),
            lambda: check_signals(recording, drives, right),
            lambda: check_rate(recording, declared),
        )
    else:
        check_signals(recording, tuple(dict.fromkeys((AxisSignals().position, *there))))
        together(lambda: check_axis(recording, declared), lambda: _check_moved(recording))


def _check_moved(recording: Recording) -> None:
    """Check that a force is compared, of an axis that is moved from outside."""
    force = PrescribedSignals().force
    if recording.channels[AxisSignals().position].role != "input":
        return
    check_signals(recording, (force,), MOVED)
    if recording.channels[force].role != "measured":
        what, right = "nothing would be compared", '"measured": what it took to move the axis'
        path = f"channels.{force}.role"
        raise InvalidInput([Problem(recording.map.source, path, what, "input", right)])


def check_signals(
    recording: Recording, needed: Sequence[str], right: str = "a channel of that name"
) -> None:
    """Check that the map names all channels `needed` and that every run holds them.

    Raises
    ------
    InvalidInput
        With one problem for each channel that is missing from the map or from a run.
    """
    logged = "numbers in every run, or another recording"
    there = f"channels {', '.join(recording.channels)} alone"
    problems = [
        Problem(recording.map.source, f"channels.{name}", "missing", there, right)
        for name in needed
        if name not in recording.channels
    ]
    problems += [
        Problem(recording.source, run.name, f"{name} was not logged here", "no number", logged)
        for run in recording.runs
        for name in needed
        if name in recording.channels and name not in run.channels
    ]
    if problems:
        raise InvalidInput(problems)


def check_tolerances(declared: Scenario, places: Problems | None = None) -> None:
    """Check that the model says how well its parameters are known (``[[tolerances]]``).

    `places` knows where in its file they stand; without it the model's name is told.

    Raises
    ------
    InvalidInput
        If nothing is said, or of an unknown parameter, or of one twice.
    """
    groups = declared.notes.get("tolerances", ())
    known = [n for n in declared.parameter_names() if not n.startswith("controller.")]
    every = [(k, name) for k, g in enumerate(groups) for name in g["parameters"]]

    def where(k: int, key: str) -> str:
        return places.place(("tolerances", k, key)) if places is not None else declared.name

    problems = [
        Problem(
            where(k, "parameters"), f"tolerances: {groups[k]['name']}", "no such parameter", name,
            one_of(known, name),
        )
        for k, name in every
        if name not in known
    ]  # fmt: skip
    for what, key, told in (
        ("this name", "name", [(k, g["name"]) for k, g in enumerate(groups)]),
        ("this parameter", "parameters", every),
    ):
        last = {name: k for k, name in told}
        for name, n in Counter(name for _, name in told).items():
            if n > 1:
                said = f"{what} stands more than once"
                place = where(last[name], key)
                problems.append(Problem(place, f"tolerances: {name}", said, str(n), "1"))
    if not groups:
        what = "which parameters are known how well is not said"
        problems.append(
            Problem(declared.name, "tolerances", what, "none", f"[[tolerances]]: {one_of(known)}")
        )
    if problems:
        raise InvalidInput(problems)
