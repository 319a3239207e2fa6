"""A diagnosis as plain data: what the JSON file holds and the page shows."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from itertools import zip_longest
from typing import Any

import numpy as np

from ...versions import source_digest, versions
from ..false_alarms import FalseAlarms
from ..far_off import by_its_inverse
from ..fitting.floor import replicate_noise
from ..held_out_gains import HeldOutGain
from ..held_out_predictions import HeldOutPredictions
from ..identifiability_report import Sight
from ..recordings.recording import Recording, finding_text
from ..result import Diagnosis
from .apart import apart_sentence
from .beyond_fitted import beyond_fitted_sentence
from .cautions import (
    cut_off_sentence,
    cut_short_sentence,
    driver_sentence,
    far_off_sentence,
    in_view_of,
    no_place_sentence,
    passed_over_sentence,
    ruling_run_sentence,
)
from .creeping import creeping_sentence
from .dependence_text import is_straight
from .doubted_sentence import doubted_sentence
from .dying_out import dying_out_sentence
from .few_windows import few_windows_sentence
from .hardly_fitted import hardly_fitted_sentence
from .held_drives import held_drives_sentence
from .held_out_data import (
    breakaway_rows,
    errors_of_experiments,
    gain_rows,
    lack_of_fit_rows,
    noise_of_channels,
    not_compared,
)
from .held_out_sentences import curve_sentence, harmful_sentence, worse_sentence
from .late_speed import of_late_speed
from .level_data import level_data
from .nearly_repeated import nearly_repeated_sentence
from .next_runs import NextRun
from .not_shown import (
    outdone_sentence,
    unborne_sentence,
    uneven_sentence,
    unsteady_sentence,
)
from .odd_rows import odd_rows_sentence
from .one_direction import one_direction_sentence
from .one_run import holding_sentence
from .pace import pace_sentence
from .parameters import parameter_rows
from .refits import one_factor_text, refits_told
from .remarks import failed_sentence, made
from .repeating_sentence import repeating_sentence
from .round_data import round_data
from .run_errors import errors_of_runs
from .sentences import (
    at_limit_sentence,
    class_sentence,
    forms_of,
    or_sensor_sentence,
    rings_sentence,
    trials_sentence,
    verdict_sentence,
)
from .shown_sizes import sizes_told
from .sight_data import sight_data, unseen
from .sight_sentences import blind_sentence, in_classes, next_sentence, shown_by
from .spoilt_kinds import spoilt_told
from .swinging import swinging_sentence
from .taken_away import declared_sentence
from .told_apart import repeated_sentence, told_apart_by_the_model


def diagnosis_data(
    found: Diagnosis,
    recording: Recording,
    told: HeldOutPredictions,
    sight: Sight | None,
    trials: FalseAlarms | None = None,
    gains: Sequence[Sequence[HeldOutGain]] = (),
    planned: Mapping[str, NextRun] | None = None,
    failed: dict[str, Exception] | None = None,
) -> dict[str, Any]:
    """Everything a reader of the JSON needs; numbers in SI units.

    `told` and `gains` (of the candidates of each round) are of the runs held out; `planned` are the
    runs that could be made next; `failed` takes up remarks that fail, which are raised without it.
    """
    done, taken = found.search, found.recording or recording
    parameters, errors = parameter_rows(found), _errors(found, taken, told)
    of_runs = errors_of_runs(found)
    return {
        "verdict": done.verdict.kind,
        "straight": is_straight(found),
        **made(_sentences(found, recording, told), failed),
        **made(_sentences_on_rows(found, parameters, errors, of_runs, gains), failed),
        "failed": failed_sentence(failed or {}),
        "run_to_run": level_data(found),
        "effects": [e.name for e in done.corrected.effects],
        "acts_at": {e.name: list(e.at) for e in done.corrected.effects if e.at},
        "other_forms": {e.name: forms_of(found, e.name) for e in done.corrected.effects},
        "rivals": [t.candidate.name for t in done.verdict.rivals],
        "depends_on": list(done.verdict.coordinates),
        "as_well": list(done.verdict.as_well),
        **errors,
        "error_of_runs": of_runs,
        "selecting": {
            "refitted": done.refitted.select_error, "after": done.corrected.select_error,
            "floor": done.floor, "after_over_floor": done.corrected.select_error / done.floor,
        },
        "parameters": parameters,
        "trials": trials_sentence(trials),
        "rounds": [round_data(r, g) for r, g in zip_longest(done.rounds, map(gain_rows, gains))],
        "not_fitted": not_fitted(found),
        "unfinished": found.unfinished,
        "rings": rings_sentence(found),
        "empirical": _empirical(found),
        **_sight(found, sight, planned or {}),
        "data": _used(found, recording),
        "versions": versions() | {"source": source_digest()},
        "seed": 1,
    }  # fmt: skip


def _sight(
    found: Diagnosis, sight: Sight | None, planned: Mapping[str, NextRun]
) -> dict[str, Any]:  # fmt: skip
    """What the runs see, and which should be made next."""
    if sight is None:
        return {"sees": None, "next": "", "blindness": ""}
    words = {name: run.words for name, run in planned.items()}
    left, blind = unseen(found, sight), {*sight.blind}
    # What was found is left out of what is not seen: then it is no list of all that is.
    visible = [n for n in sight.visible if n not in blind] if {*left} == blind else None
    classes = in_classes(left, found.candidates)
    return {
        "sees": sight_data(sight, found, words),
        "next": next_sentence(found, sight, words),
        "blindness": blind_sentence(classes, shown_by(sight, left), visible),
    }


def _sentences(
    found: Diagnosis, recording: Recording, told: HeldOutPredictions
) -> dict[str, Callable[[], str]]:
    """The verdict in words, and what has to be known of it; "" what does not apply."""
    verdict, taken = found.search.verdict, found.recording or recording
    # A pass that came to its end has left out what promised too little, and nothing else.
    unfitted = 0 if found.unfinished else len(not_fitted(found))
    return {
        "sentence": lambda: in_view_of(
            recording.still, verdict_sentence(found) + one_factor_text(found), found.doubts,
            found.cut_short, unfitted, found.far_off, of=len(found.candidates),
        ),
        "doubted": lambda: doubted_sentence(
            found.doubts, found.search.floor / found.search.refitted.select_error
        ),
        "apart": lambda: apart_sentence(recording, found.doubts),
        "far_off": lambda: far_off_sentence(found.far_off, _inverse(found, taken)),
        "driver": lambda: driver_sentence(found.remarks),
        "pace": lambda: pace_sentence(told),
        "ruling_run": lambda: ruling_run_sentence(found.ruling_run),
        "cut_off": lambda: cut_off_sentence(recording.findings),
        "odd_rows": lambda: odd_rows_sentence((*recording.findings, *found.remarks)),
        "cut_short": lambda: cut_short_sentence(
            found.cut_short, unfitted, found.interrupted, found.unfinished
        ),
        "kind": lambda: class_sentence(found),
        "or_sensor": lambda: or_sensor_sentence(found),
        "at_limit": lambda: at_limit_sentence(found),
        "less_drag": lambda: declared_sentence(found),
        "worse": lambda: worse_sentence(found),
        "harmful": lambda: harmful_sentence(found),
        "few_windows": lambda: few_windows_sentence(found, told),
        "one_run": lambda: holding_sentence(found),
        "hardly_fitted": lambda: hardly_fitted_sentence(found),
        "beyond_fitted": lambda: beyond_fitted_sentence(found, taken),
        "passed_over": lambda: passed_over_sentence(found.search),
        "repeated": lambda: repeated_sentence(
            found.repeated, found.over_noise, told_apart_by_the_model(found, taken),
            turns=not is_straight(found),
        ),
        "nearly_repeated": lambda: nearly_repeated_sentence([*found.fitted, *found.split.select]),
        "between_rows": lambda: held_drives_sentence(found, recording),
        "creeping": lambda: creeping_sentence(told, taken),
        "swings": lambda: swinging_sentence(found, told),
        "repeats": lambda: repeating_sentence(found),
        "one_direction": lambda: one_direction_sentence(found),
        "dying_out": lambda: dying_out_sentence(found),
        "no_place": lambda: no_place_sentence(recording, verdict),
        "late_speed": lambda: of_late_speed(found, recording),
    }  # fmt: skip


def _sentences_on_rows(
    found: Diagnosis, parameters: Any, errors: Mapping[str, Any], of_runs: Any,
    gains: Sequence[Sequence[HeldOutGain]],
) -> dict[str, Callable[[], str]]:  # fmt: skip
    """What has to be known of the rows of the report: of parameters, errors and gains."""
    of_experiments = errors["error_of_experiments"]
    floors = {n: e["floor"] for n, e in of_experiments.items() if "floor" in e}
    return {
        "refit": lambda: refits_told(found, parameters),
        "spoilt": lambda: spoilt_told(found, of_experiments, of_runs),
        "uneven": lambda: uneven_sentence(found, of_experiments, of_runs),
        "unsized": lambda: sizes_told(found, parameters, gains),
        "unborne": lambda: unborne_sentence(found, gains),
        "outdone": lambda: outdone_sentence(found, gains),
        "unsteady": lambda: unsteady_sentence(floors),
    }


def _inverse(found: Diagnosis, taken: Recording) -> str:
    """What does the same as a declared number that is far off, where nothing drives the axis."""
    if found.far_off is None or taken.map.driven:
        return ""
    model: Any = found.search.refitted
    return by_its_inverse(found.far_off, model.predictor.declared)


def _errors(found: Diagnosis, taken: Recording, told: HeldOutPredictions) -> dict[str, Any]:
    """Errors on the runs held out, in all cuts."""
    return {
        "error": {
            "unit": "weighed deviations, reported runs (over floor: times the noise)",
            **{k: float(v) for k, v in found.error_by_stage.items()},
        },
        "error_of_channels": {k: dict(v) for k, v in found.errors.items()},
        "units_of_channels": {n: (c.unit, c.unit_scale) for n, c in taken.channels.items()},
        "noise_of_channels": noise_of_channels(told, taken),
        "not_compared": not_compared(found, taken),
        "error_of_experiments": errors_of_experiments(found),
        "breakaways": breakaway_rows(told),
        "lack_of_fit": lack_of_fit_rows(told, replicate_noise(found.fitted), found.floors.report),
    }


def _used(found: Diagnosis, recording: Recording) -> dict[str, Any]:
    """Which data were used for what, and what was found wrong with them."""
    findings = (*recording.findings, *found.remarks)
    return {
        "recording": "/".join(recording.source.split("/")[-2:]),
        "runs": len(recording.runs),
        "used_for": {k: list(v) for k, v in found.groups.items()},
        "findings": [finding_text(f, recording) for f in findings],
        "absent": list(recording.absent),
    }


def _empirical(found: Diagnosis) -> dict[str, Any] | None:
    term = found.empirical
    if term is None:
        return None
    return {
        "sentence": curve_sentence(found),
        "coordinate": term.coordinate,
        "effect": term.trial.candidate.name,
        "gain": term.trial.gain,
        "selecting": term.model.select_error,
        "place": term.place.tolist(),
        "value": term.value.tolist(),
        "half_width": [h if np.isfinite(h) else None for h in term.half_width.tolist()],
    }


def not_fitted(found: Diagnosis) -> list[str]:
    """Candidates that were not fitted in the first round; none where no fit was called for."""
    rounds = found.search.rounds
    fitted = {t.candidate.name for t in rounds[0].trials} if rounds else set()
    if not fitted and not found.cut_short:
        return []
    return [c.name for c in found.candidates if c.name not in fitted]
