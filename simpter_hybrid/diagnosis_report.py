"""A diagnosis from files to files: the result of a request, and the report of it."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from difflib import unified_diff
from pathlib import Path
from textwrap import wrap
from typing import Any

from .files.json_text import json_text
from .files.scenario_text import resolve
from .identification.diagnosis import diagnose, trials_of
from .identification.fitting.effort import never
from .identification.held_out_gains import held_out_gains
from .identification.held_out_predictions import HeldOutPredictions, held_out_predictions
from .identification.identifiability_request import seen_by
from .identification.reporting.data import diagnosis_data
from .identification.reporting.directory import MARK, check_free, put
from .identification.reporting.next_runs import NextRun, next_runs, next_runs_csv
from .identification.reporting.page import DOUBTED, TOLD, page
from .identification.reporting.request import Request
from .identification.reporting.sight_data import unseen
from .identification.reporting.sight_sentences import advised
from .identification.result import Diagnosis, corrected, with_curve
from .identification.tracing.verdict import LEAST_SHARE
from .problems import InvalidInput
from .scenario import Scenario

#: Sentences of a result in the order in which they are told: with a wrong sign or unit no verdict
#: is worth reading, so that question comes first.
TOLD_FIRST = *DOUBTED, "sentence"
TOLD_LAST = *TOLD, "run_to_run", "empirical", "next", "blindness", "trials"
#: Columns of the comment at the head of a corrected model.
WIDTH = 98


@dataclass(frozen=True)
class DiagnosisReport:
    """What a recording shows its model to lack.

    Parameters
    ----------
    found : Diagnosis
        The search: models, candidates, errors, runs.
    data : mapping
        All that is told, as ``diagnosis.json`` has it: ``data["verdict"]`` (a kind, as
        ``"effect"``), ``data["effects"]``, ``data["error"]`` of the runs held out and more.
    corrected : Scenario
        The corrected model; the declared one, refitted, where nothing was named.
    text : str
        That as a file.
    files : mapping of str to str
        Further files by their names: of what the corrected model names, its map, and the model
        with a curve over what is left, if there is one.
    stages : HeldOutPredictions
        The runs held out with their predictions by the refitted and the corrected model.
    gains : sequence
        What every candidate takes away on the runs held out.
    next_runs : tuple of NextRun
        Those to make next, the first first.
    failed : tuple of Exception
        Of remarks that could not be made: raised when the report has been saved.
    """

    found: Diagnosis
    data: Mapping[str, Any]
    corrected: Scenario
    text: str
    files: Mapping[str, str]
    stages: HeldOutPredictions
    gains: Any
    next_runs: tuple[NextRun, ...] = ()
    failed: tuple[Exception, ...] = ()

    def __str__(self) -> str:
        return "\n".join(sentences(self.data))

    def save(self, directory: str | os.PathLike[str], overwrite: bool = False) -> Path:
        """Write the report, its data and pictures, and the corrected model.

        Parameters
        ----------
        directory : path
            Made if needed; an earlier diagnosis loses nothing before all is on the disk.
        overwrite : bool
            Replace a directory that holds a diagnosis.

        Returns
        -------
        Path
            The directory.

        Raises
        ------
        InvalidInput
            If the directory is not free.
        OSError
            If it cannot be written.
        """
        check_free(Path(directory), overwrite)
        try:
            from .plots.diagnosis import pictures
            from .plots.next_run import next_run_pictures

            drawn = pictures(self.found, self.stages, self.found.recording, self.gains)
            drawn |= next_run_pictures(self.next_runs)
        except Exception:  # whatever a picture comes to, what took minutes to find is kept
            self._put(Path(directory), {}, overwrite)
            raise
        self._put(Path(directory), drawn, overwrite)
        if self.failed:
            raise self.failed[0]
        return Path(directory)

    def _put(self, directory: Path, drawn: Mapping[str, bytes], overwrite: bool) -> None:
        report = page(self.data, drawn, self.text)
        texts = {"corrected.toml": self.text, **self.files, "report.html": report}
        whole = {name: content.encode() for name, content in texts.items()}
        whole |= {f"{name}.png": picture for name, picture in drawn.items()}
        told = {**self.data, "files": sorted([MARK, *whole])}
        check_free(directory, overwrite)  # another may have written there meanwhile
        put(directory, whole | {MARK: json_text(told).encode()})


def diagnosed(
    request: Request,
    say: Callable[[str], None] = lambda text: None,
    remark: Callable[[str], None] | None = None,
    ended: Callable[[], bool] = never,
) -> DiagnosisReport:
    """Carry out a request.

    Parameters
    ----------
    request : Request
    say : callable
        Told what is being done.
    remark : callable, optional
        Told what may be wrong with the data; default: `say`.
    ended : callable, optional
        Asked whether somebody has ended the search: what was found by then is told, without what
        these experiments see, without trials, and of the best candidate of each round alone what it
        does to the runs held out.

    Raises
    ------
    InvalidInput
        If the model or the recording does not fit the task, or there is no such effect.
    """
    try:
        return _diagnosed(request, say, remark, ended)
    except InvalidInput as wrong:  # a user looks for the file, not for the model's name
        where = {request.declared.name: str(request.model)}
        problems = [p._replace(where=where.get(p.where, p.where)) for p in wrong.problems]
        raise InvalidInput(problems) from None


def _diagnosed(
    request: Request,
    say: Callable[[str], None],
    remark: Callable[[str], None] | None,
    ended: Callable[[], bool],
) -> DiagnosisReport:
    recording, name, seen, trials = request.recording, request.name, None, None
    found = diagnose(
        recording, request.declared, say=say, without=request.without, also=request.also,
        remark=remark, effort=request.effort, ended=ended,
    )  # fmt: skip
    if request.sight and not ended():
        say("computing what these experiments see")
        seen = seen_by(found)
    if request.trials > 0 and not ended():
        say(f"diagnosing {request.trials} synthetic sets in which nothing is missing")
        trials = trials_of(found, request.trials, request.effort)
    # Who has ended the search does not wait for candidates that are named by nobody.
    of_best = {"most": 2} if ended() else {}
    say(f"asking the runs held out of {'what was found' if of_best else 'every candidate'}")
    gains = held_out_gains(found.search, found.split.report, **of_best)
    found = replace(found, gains=gains)
    stages = held_out_predictions(found)
    planned = next_runs(seen, found.recording or recording)
    failed: dict[str, Exception] = {}
    data = diagnosis_data(found, recording, stages, seen, trials, gains, planned, failed)
    data["data"]["sha256"] = dict(request.digests)
    data["asked"], data["left_out"] = request.asked, request.left_out
    model = corrected(found, f"{name}-corrected")
    resolved = resolve(model)
    data["model_diff"] = changes(resolve(request.declared).text, resolved.text)
    # The map beside the corrected model: so this can be diagnosed again without naming one.
    again = {"corrected_map.toml": request.map_text}
    files = dict(resolved.files) | again
    curved = with_curve(found, f"{name}-empirical")
    if curved is not None:
        more = resolve(curved)
        files |= dict(more.files) | {"empirical.toml": more.text}
    text = _headed(name, data, resolved.text)
    asked = tuple(planned[n] for n in advised(found, seen, unseen(found, seen)) if n in planned)
    if table := next_runs_csv(asked):
        files["run_next.csv"] = table
    wrong = tuple(failed.values())
    return DiagnosisReport(found, data, model, text, files, stages, gains, asked, wrong)


def _headed(name: str, data: Mapping[str, Any], text: str) -> str:
    """A corrected model's file, with what it is the correction of in front, and where it is none.

    Who takes the file alone along has not read the report.
    """
    told = f"By `simpter diagnose {name}`. {data['sentence']} {data['worse']}".rstrip()
    said = "".join(c if c.isprintable() else "?" for c in told)  # else it were no TOML
    lines = wrap(said, WIDTH - 2, break_on_hyphens=False)
    return "".join(f"# {line}\n" for line in lines) + text


def sentences(data: Mapping[str, Any]) -> list[str]:
    """What a result says, in the order in which it matters.

    Parameters
    ----------
    data : mapping
        As `DiagnosisReport.data`.
    """
    told = dict(data)
    told["empirical"] = data["empirical"]["sentence"] if data["empirical"] else ""
    own = data["run_to_run"]  # the report has also what explains little
    much = own and own["parameters"][-1]["share"] >= LEAST_SHARE
    told["run_to_run"] = own["sentence"] if much else ""
    return [told[key] for key in (*TOLD_FIRST, *TOLD_LAST) if told[key]]


def changes(declared: str, corrected: str) -> list[str]:
    """Lines of a unified diff between two scenarios.

    Parameters
    ----------
    declared, corrected : str
        Both as texts of files.

    Returns
    -------
    list of str
        Without line ends; empty if there is no difference.
    """
    before, after = declared.splitlines(), corrected.splitlines()
    return list(unified_diff(before, after, "declared", "corrected", lineterm="", n=1))
