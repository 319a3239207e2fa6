"""Diagnose the recordings of real rigs; what is left on runs that had no part in it.

    python benchmarks/real_recordings.py            # all rigs of the table
    python benchmarks/real_recordings.py emps       # one of them

Writes ``real_recordings.csv`` beside this file: one row for a rig and a measure, with the error of
the declared model, refitted within tolerance, with what was found, with the best single candidate
even where the verdict does not name it, and of the authors' published model under the same measure.
"""

from __future__ import annotations

import argparse
import csv
import sys
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from emps_force import relative_error
from measured import DATA, recordings
from program import commit

from simpter_hybrid.effects.bias_force import BiasForce
from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.fitting.residual import channel_errors
from simpter_hybrid.identification.maps import MAPS, find_model
from simpter_hybrid.identification.recordings.recording import Recording, load_recording
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.result import Diagnosis
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.scenario import Scenario

HERE = Path(__file__).parent
COLUMNS = (
    "rig", "verdict", "named", "not excluded", "measure", "declared", "refitted", "after",
    "best candidate", "with it", "published model", "authors state", "commit",
)  # fmt: skip
#: Models as the authors published them: parameters, and further effects (README of each rig).
PUBLISHED: dict[str, tuple[dict[str, float], tuple]] = {
    "emps": (
        {"device.mass": 95.1089, "clutch.1.torque.coulomb": 20.3935,
         "clutch.1.torque.viscous": 203.5034},
        # Their offset is on the force that the motor must give.
        (BiasForce(bias=3.1648, coordinate=0),),
    ),
    "dfki_pendulum": (
        {"device.inertia": 0.06259, "device.weight": 0.1022 * 9.81,
         "clutch.1.torque.coulomb": 0.1839 * np.pi / 2, "clutch.1.torque.viscous": 0.04707},
        (BiasForce(bias=0.07586, coordinate=0),),
    ),
    "dfki_double_pendulum": (
        {"clutch.1.torque.coulomb": 0.16, "clutch.2.torque.coulomb": 0.12,
         "clutch.1.torque.viscous": 0.001, "clutch.2.torque.viscous": 0.001},
        (),
    ),
}  # fmt: skip
STATED = {
    ("emps", "force by the authors' filter, relative [%]"): "5.98 (cross-test)",
    ("bam_xl330", "free run: position, mean absolute [rad]"): "0.12 to 0.14 (M1 to M6)",
}


@dataclass(frozen=True)
class Stage:
    """A model under its name in the table: predictor and values."""

    predictor: ScenarioPredictor
    values: Mapping[str, float]


def stages(name: str, found: Diagnosis, declared: Scenario) -> dict[str, Stage]:
    """All models of a row."""
    done = found.search
    base: ScenarioPredictor = done.refitted.predictor  # type: ignore[assignment]
    nominal = {p.name: p.value for p in base.parameters}
    made = {
        "declared": Stage(base, nominal),
        "refitted": Stage(base, done.refitted.values),
        "after": Stage(done.corrected.predictor, done.corrected.values),  # type: ignore[arg-type]
    }
    trials = done.rounds[0].trials if done.rounds else ()
    if trials:
        best = trials[0]
        made["with it"] = Stage(base.extended(best.candidate), best.fit.values)
    if name in PUBLISHED and PUBLISHED[name][0]:
        values, effects = PUBLISHED[name]
        scenario = with_parameters(declared, values)
        scenario = replace(scenario, effects=(*scenario.effects, *effects))
        made["published model"] = Stage(replace(base, declared=scenario), nominal)
    return made


def as_compared(found: Diagnosis, recording: Recording, stage: Stage) -> dict[str, float]:
    """Root mean square over the channels that the diagnosis compares, on the held-out runs."""
    report = found.split.report
    errors = channel_errors(stage.predictor.predict(stage.values, report), report)
    return {f"{channel}, rms [SI]": value for channel, value in errors.items()}


def one_by_one(found: Diagnosis, recording: Recording, stage: Stage) -> dict[str, float]:
    """The same for each held-out run."""
    result = {}
    for replay in found.split.report:
        errors = channel_errors(stage.predictor.predict(stage.values, [replay]), [replay])
        result |= {f"{channel} of {replay.name}, rms [SI]": v for channel, v in errors.items()}
    return result


def derived_speed(found: Diagnosis, recording: Recording, stage: Stage) -> dict[str, float]:
    """Root mean square error of the speed, where the record's was derived from positions."""
    report = found.split.report
    told = stage.predictor.predict(stage.values, report)["speed"]
    errors = np.concatenate([r.notes["speed"] - p for r, p in zip(report, told, strict=True)])
    return {"speed from positions, rms [SI]": float(np.sqrt(np.mean(errors**2)))}


def free_run(found: Diagnosis, recording: Recording, stage: Stage) -> dict[str, float]:
    """Mean absolute error of position when a run is never set anew from the record."""
    replays = [replace(r, restarts=()) for r in found.split.report]
    told = stage.predictor.predict(stage.values, replays)["position"]
    errors = [
        float(np.mean(np.abs(r.notes["position"] - p))) for r, p in zip(replays, told, strict=True)
    ]
    return {"free run: position, mean absolute [rad]": float(np.mean(errors))}


def filtered_force(found: Diagnosis, recording: Recording, stage: Stage) -> dict[str, float]:
    """The authors' relative error of the force, which needs no controller: `emps_force`."""
    runs = [r for r in recording.runs if r.group in found.groups["report"]]
    scenario = stage.predictor.scenario(stage.values)
    errors = [relative_error(scenario, run) for run in runs]
    return {"force by the authors' filter, relative [%]": float(np.mean(errors))}


Measure = Callable[[Diagnosis, Recording, Stage], dict[str, float]]
#: File below the folder of the data, and what is measured.
RIGS: dict[str, tuple[str, tuple[Measure, ...]]] = {
    "emps": ("emps/data.csv.gz", (as_compared, derived_speed, filtered_force)),
    "bam_xl330": ("bam_xl330/data.csv", (as_compared, free_run)),
    "pneu_seal": ("pneu_seal/data.csv.gz", (as_compared,)),
    "pneu_seal_repeats": ("pneu_seal/data.csv.gz", (as_compared,)),
    "dfki_pendulum": ("dfki_pendulum/data.csv", (as_compared, one_by_one)),
    "dfki_double_pendulum": ("dfki_double_pendulum/data.csv.gz", (as_compared, one_by_one)),
}


def rows(name: str) -> list[dict[str, str]]:
    """Every measure of one rig."""
    file, measures = RIGS[name]
    declared = load(find_model(name))
    recording = load_recording(DATA / file, MAPS / f"{name}.toml")
    found = diagnose(recording, declared)
    print(f"{name}: {verdict_sentence(found)}", file=sys.stderr)
    done = found.search
    trials = done.rounds[0].trials if done.rounds else ()
    table: dict[str, dict[str, str]] = {}
    for stage_name, stage in stages(name, found, declared).items():
        for measure in measures:
            for words, value in measure(found, recording, stage).items():
                table.setdefault(words, {})[stage_name] = f"{value:.4g}"
    head = {
        "rig": name, "verdict": done.verdict.kind,
        "named": " ".join(e.name for e in done.corrected.effects),
        "not excluded": " ".join((*(t.candidate.name for t in done.verdict.rivals),
                                  *done.verdict.as_well)),
        "best candidate": trials[0].candidate.name if trials else "",
    }  # fmt: skip
    return [
        {
            **head,
            "measure": words,
            **values,
            "authors state": STATED.get((name, words), ""),
            "commit": commit(),
        }
        for words, values in table.items()
    ]


def main() -> None:
    """Replace the rows of the rigs asked for."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("rig", nargs="*", help=", ".join(RIGS))
    args = parser.parse_args()
    table = HERE / "real_recordings.csv"
    kept: list[dict[str, str]] = []
    if table.exists():
        with table.open(encoding="utf-8", newline="") as handle:
            kept = list(csv.DictReader(handle))
    for name in args.rig or RIGS:
        recordings(RIGS[name][0].partition("/")[0])
        cpu = time.process_time()
        made = rows(name)
        kept = [row for row in kept if row["rig"] != name] + made
        with table.open("w", encoding="utf-8", newline="") as handle:
            writer = csv.DictWriter(handle, COLUMNS, lineterminator="\n")
            writer.writeheader()
            writer.writerows(sorted(kept, key=lambda row: list(RIGS).index(row["rig"])))
        print(f"{name}: {time.process_time() - cpu:.0f} s CPU", file=sys.stderr)


if __name__ == "__main__":
    main()
