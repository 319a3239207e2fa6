"""Find out what a model lacks against a recording; write a report and the corrected model."""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from difflib import unified_diff
from pathlib import Path
from typing import Any

from . import DONE

#: Files that not every diagnosis has: an earlier one's must not stay beside a new report.
SOMETIMES = (
    "empirical.toml", "added.png", "curve.png", "dependence.png", "ranking.png", "held_out.png",
    "residual.png",
)  # fmt: skip
#: Remarks on the recording that are said at once; the report has all.
LISTED = 3
HELP = "trace measured data to what the model lacks"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "recordings", metavar="RECORDING", nargs="+",
        help="CSV, TSV (also gzipped), NPZ, MAT or TDMS file; several if each holds a run",
    )  # fmt: skip
    parser.add_argument("--model", required=True, help="declared model: a scenario's TOML file")
    parser.add_argument("--map", help="TOML map of the recording (default: beside the model or it)")
    parser.add_argument("--out", metavar="DIR", help="where the files go (out/diagnose-NAME)")
    parser.add_argument("--force", action="store_true", help="replace an earlier diagnosis")
    parser.add_argument("--no-sight", action="store_true", help="skip what the data are blind to")
    parser.add_argument(
        "--without", metavar="EFFECT", action="append", default=[],
        help="leave an effect out of the library (again for more): is its lack then unknown?",
    )  # fmt: skip
    parser.add_argument(
        "--also", metavar="EFFECT", action="append", default=[],
        help="try an effect that the library lacks: a kind, or module:Class of a file beside the "
        "model (again for more)",
    )  # fmt: skip
    parser.add_argument(
        "--trials", metavar="N", type=int, default=0,
        help="diagnose N synthetic sets of these runs in which nothing is missing: false alarms",
    )  # fmt: skip
    parser.add_argument(
        "--effort", metavar="TIMES", type=float, default=1.0,
        help="how much may be simulated, in times the usual (a quarter of an hour on two cores)",
    )  # fmt: skip
    parser.add_argument("--json", action="store_true", help="the result as data on stdout")
    parser.add_argument("--quiet", action="store_true", help="no progress on stderr")


def execute(args: argparse.Namespace) -> int:
    """Read, diagnose, write; 0 whatever the verdict, since each is a result."""
    from ..identification.maps import find_map, find_model
    from ..identification.recordings.recording import finding_text, load_recording
    from ..identification.reporting.sources import name_of
    from ..problems import InvalidInput, together
    from ..scenario_file import load

    began = time.monotonic()

    def say(text: str) -> None:
        if not args.quiet:
            print(f"{time.monotonic() - began:6.0f} s  {text}", file=sys.stderr, flush=True)

    def remark(text: str) -> None:  # no progress: what may be wrong with the data is always told
        if args.quiet:
            print(text, file=sys.stderr, flush=True)
        say(text)

    model = find_model(args.model)
    recording_map = find_map(args.map, args.recordings[0], model)
    name = name_of(args.recordings)
    directory = Path(args.out if args.out is not None else f"out/diagnose-{name}")
    declared, also, recording, _ = together(
        lambda: load(model),
        lambda: effects_named(args.also, model.parent),
        lambda: load_recording(args.recordings, recording_map),
        lambda: check_free(directory, args),
    )
    say(f"{len(recording.runs)} runs read, as {recording_map} has them")
    for finding in recording.findings[:LISTED]:
        remark(finding_text(finding, recording))
    if (more := len(recording.findings) - LISTED) > 0:
        remark(f"{more} more remarks on the recording stand in the report")
    sources = {"model": model, "map": recording_map}
    try:
        told = say, remark
        drawn_from, data, text, files = diagnose(recording, declared, also, sources, args, told)
    except InvalidInput as wrong:  # a user looks for the file, not for the model's name
        where = {declared.name: str(model)}
        problems = [p._replace(where=where.get(p.where, p.where)) for p in wrong.problems]
        raise InvalidInput(problems) from None
    # Said before it is written: a disk that is full then costs the report and not the answer.
    tell(data, args.json)
    write(directory, drawn_from, data, text, files, say)
    if not args.json:
        print(f"report in {directory}")
    return DONE


def effects_named(kinds: list[str], folder: Path) -> list[Any]:
    """Classes of effects by their kinds; every name that is none is told at once."""
    from ..problems import InvalidInput, Problem
    from ..reading.kinds import UnknownKindError, find

    found, problems = [], []
    for kind in kinds:
        try:
            found.append(find("effect", kind, folder))
        except UnknownKindError as error:
            problems.append(Problem("--also", "", error.what, kind, error.right))
    if problems:
        raise InvalidInput(problems)
    return found


def tell(data: Any, as_data: bool) -> None:
    """The result on standard output."""
    from ..storage import json_text

    if as_data:
        sys.stdout.write(json_text(data))
        return
    curve = data["empirical"]["sentence"] if data["empirical"] else ""
    # With a wrong sign or unit no verdict is worth reading: that question comes first.
    also = (
        data["hardly_fitted"],
        data["worse"],
        data["few_windows"],
        data["at_limit"],
        data["refit"],
        data["rings"],
        curve,
        data["repeated"],
        data["between_rows"],
        data["no_place"],
        data["creeping"],
        data["swings"],
        data["next"],
        data["blindness"],
        data["trials"],
    )
    first = data["doubted"], data["cut_off"], data["cut_short"], data["sentence"]
    for sentence in filter(None, (*first, *also)):
        print(sentence, flush=True)


def check_free(directory: Path, args: argparse.Namespace) -> None:
    """Refuse, before anything is computed, what cannot be written or counted."""
    from ..identification.rigs.scenario_runner import threads
    from ..problems import InvalidInput, Problem
    from ..run_directory import check_makeable

    problems = []
    if args.trials < 0:
        problems.append(Problem("--trials", "", "less than none", str(args.trials), "0 or more"))
    if not args.effort > 0.0:
        problems.append(Problem("--effort", "", "no effort", str(args.effort), "a number above 0"))
    taken = directory.exists() and (not directory.is_dir() or any(directory.iterdir()))
    ours = (directory / "diagnosis.json").is_file()
    try:
        threads()
    except InvalidInput as wrong:
        problems += wrong.problems
    try:
        check_makeable(directory / "diagnosis.json")
    except OSError as error:
        right = "a directory that can be written"
        problems.append(Problem("--out", "", str(error), str(directory), right))
    else:
        if taken and not (args.force and ours):
            more = ", or --force to replace a diagnosis"
            more = ": this one holds no diagnosis" if args.force else more
            right = f"the name of a new directory (--out){more}"
            problems.append(Problem("--out", "", "not free", str(directory), right))
    if problems:
        raise InvalidInput(problems)


def diagnose(
    recording: Any, declared: Any, also: list, sources: dict[str, Path], args: Any, told: tuple
) -> tuple:
    """What pictures are drawn from, data, the corrected model and files it names."""
    say, remark = told
    from ..identification.diagnosis import diagnose as search
    from ..identification.diagnosis import trials_of
    from ..identification.found import corrected, with_curve
    from ..identification.held_out_gains import held_out_gains
    from ..identification.reported import reported
    from ..identification.reporting.data import diagnosis_data
    from ..identification.reporting.sources import digests, name_of
    from ..identification.seen import seen_by
    from ..scenario_text import resolve

    found = search(
        recording, declared, say=say, without=args.without, also=also, remark=remark,
        effort=args.effort,
    )  # fmt: skip
    name, seen = name_of(args.recordings), None
    if not args.no_sight:
        say("computing what these experiments see")
        seen = seen_by(found)
    trials = None
    if args.trials > 0:
        say(f"diagnosing {args.trials} synthetic sets in which nothing is missing")
        trials = trials_of(found, args.trials, args.effort)
    say("asking the runs held out of every candidate")
    gains = held_out_gains(found.diagnosis, found.split.report)
    stages = reported(found)
    data = diagnosis_data(found, recording, stages, seen, trials, gains)
    data["data"]["sha256"] = digests(args.recordings, sources["model"], sources["map"])
    resolved = resolve(corrected(found, f"{name}-corrected"))
    data["model_diff"] = changes(resolve(declared).text, resolved.text)
    # The map beside the corrected model: so this can be diagnosed again without naming one.
    again = {"corrected_map.toml": sources["map"].read_text(encoding="utf-8")}
    files = dict(resolved.files) | again
    curved = with_curve(found, f"{name}-empirical")
    if curved is not None:
        more = resolve(curved)
        files |= dict(more.files) | {"empirical.toml": more.text}
    return (found, stages, found.taken, gains), data, resolved.text, files


def changes(declared: str, corrected: str) -> list[str]:
    """Lines of a unified diff between two scenarios."""
    sides = declared.splitlines(), corrected.splitlines()
    return list(unified_diff(*sides, "declared", "corrected", lineterm="", n=1))


def write(directory: Path, drawn_from: tuple, data: Any, text: str, files: Any, say: Any) -> None:
    """All files of a diagnosis."""
    from ..identification.reporting.page import page
    from ..plots.diagnosis import pictures
    from ..storage import json_text

    say("drawing the report")
    drawn = pictures(*drawn_from)
    texts = {
        "corrected.toml": text, **files, "diagnosis.json": json_text(data),
        "report.html": page(data, drawn, text),
    }  # fmt: skip
    whole = {name: content.encode() for name, content in texts.items()}
    put(directory, whole | {f"{name}.png": png for name, png in drawn.items()})


def put(directory: Path, files: dict[str, bytes]) -> None:
    """Files into a directory: all are on the disk before an earlier diagnosis loses any."""
    new = not directory.exists()
    directory.mkdir(parents=True, exist_ok=True)
    try:
        with tempfile.TemporaryDirectory(prefix=".partial-", dir=directory) as held:
            for name, content in files.items():
                (Path(held) / name).write_bytes(content)
            for name in SOMETIMES:
                (directory / name).unlink(missing_ok=True)
            for name in files:
                os.replace(Path(held) / name, directory / name)
    except BaseException:
        if new and not any(directory.iterdir()):
            directory.rmdir()
        raise
