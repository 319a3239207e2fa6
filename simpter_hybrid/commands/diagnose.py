"""Find out what a model lacks against a recording; write a report and the corrected model."""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from . import DONE, INTERRUPTED, INVALID

if TYPE_CHECKING:
    from ..identification.reporting.request import Request

#: Remarks on the recording that are said at once; the report has all.
LISTED = 3
#: Said at the first interrupt.
KEEPING = "interrupted: what was found is kept; once more ends at once"
HELP = "trace measured data to what the model lacks"


def arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    parser.add_argument(
        "recordings", metavar="RECORDING", nargs="+",
        help="CSV, TSV (also gzipped), NPZ, MAT or TDMS file; several if each holds a run",
    )  # fmt: skip
    parser.add_argument("--model", required=True, help="declared model: a scenario's TOML file")
    parser.add_argument(
        "--map",
        help="TOML map of the recording (default: MODEL_map.toml beside the model, else map.toml "
        "beside the recording, else that of a shipped model)",
    )
    parser.add_argument("--out", metavar="DIR", help="where the files go (out/diagnose-NAME)")
    parser.add_argument("--force", action="store_true", help="replace an earlier diagnosis")
    parser.add_argument(
        "--no-sight", action="store_true",
        help="skip the analysis of what the data cannot show, and of which run would tell most",
    )  # fmt: skip
    parser.add_argument(
        "--without", metavar="NAME", action="append", default=[],
        help="leave an effect and all of its kind out of the library, by its name in verdicts "
        "(again for more): is its lack then unknown?",
    )  # fmt: skip
    parser.add_argument(
        "--also", metavar="KIND", action="append", default=[],
        help="try an effect that the library lacks: a kind of `simpter list --parts`, or "
        "module:Class of a file beside the model (again for more)",
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
    from ..diagnosis_report import diagnosed
    from ..files.json_text import json_text
    from ..identification.reporting.directory import check_free
    from ..identification.reporting.request import read_request
    from ..identification.reporting.sources import name_of
    from ..problems import InvalidInput
    from ..progress import Ending, end_as_interrupted

    end_as_interrupted()
    began = time.monotonic()

    def say(text: str) -> None:
        if not args.quiet:
            print(f"{time.monotonic() - began:6.0f} s  {text}", file=sys.stderr, flush=True)

    def remark(text: str) -> None:  # no progress: what may be wrong with the data is always told
        if args.quiet:
            print(text, file=sys.stderr, flush=True)
        say(text)

    name = name_of(args.recordings)
    directory = Path(args.out if args.out is not None else f"out/diagnose-{name}")
    request = read_request(
        args.recordings, args.model, args.map, also=args.also, without=args.without,
        effort=args.effort, trials=args.trials, sight=not args.no_sight,
        check=lambda: check_free(directory, args.force),
    )  # fmt: skip
    _tell_what_was_read(request, say, remark)
    with Ending(KEEPING) as ended:
        report = diagnosed(request, say, remark, ended)
    # Said before it is written: a disk that is full then costs the report and not the answer; and
    # written though nobody reads what is said.
    unsaid = _print(json_text(report.data) if args.json else f"{report}\n")
    say("drawing the report")
    try:
        report.save(directory, args.force)
    except InvalidInput as taken:  # meanwhile; the result has been told
        print(taken, file=sys.stderr)
        return INVALID
    if unsaid is not None:
        raise unsaid
    if not args.json:
        print(f"report in {directory}")
    return INTERRUPTED if ended() else DONE


def _tell_what_was_read(
    request: Request, say: Callable[[str], None], remark: Callable[[str], None]
) -> None:
    """Say how many runs were read and by which map; remark on what was found wrong with them."""
    from ..identification.recordings.recording import finding_text

    recording = request.recording
    count = len(recording.runs)
    runs, them = ("one run", "it") if count == 1 else (f"{count} runs", "them")
    say(f"{runs} read, as {request.map} has {them}")
    for finding in recording.findings[:LISTED]:
        remark(finding_text(finding, recording))
    if (more := len(recording.findings) - LISTED) > 0:
        remark(f"{more} more remarks on the recording stand in the report")


def _print(text: str) -> OSError | None:
    """Write to standard output; the error if nobody reads it."""
    try:
        sys.stdout.write(shown(text))
        sys.stdout.flush()
    except OSError as error:
        return error
    return None


def shown(text: str) -> str:
    """A text of which standard output can show every character; others as escapes."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    return text.encode(encoding, "backslashreplace").decode(encoding)
