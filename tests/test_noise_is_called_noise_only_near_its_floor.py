"""Where nothing helps: nothing is missing at the floor, something is well above it."""

from types import SimpleNamespace as Some

import numpy as np
import pytest
from evidence import judged

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.fitting.predictor import Parameter
from simpter_hybrid.identification.reporting.sentences import verdict_sentence
from simpter_hybrid.identification.tracing.limits import (
    REPEATED,
    SIMULATED,
    SIMULATED_AXIS,
    SINGLE,
    known_by_repetition,
)
from simpter_hybrid.identification.tracing.signature import Dependence
from simpter_hybrid.identification.tracing.verdict import Verdict

#: A sensor saw what drives the runs.
SEEN = SINGLE._replace(drive=True)
ONES = Floors(1.0, 1.0, 1.0)


def said(
    verdict,
    ratio,
    limit=REPEATED,
    held_out=None,
    rounds=(),
    recording=None,
    parameters=(),
    only=False,
    gains=(),
):
    model = Some(
        effects=(), select_error=ratio, residuals=np.full(9, 2.5),
        predictor=Some(parameters=parameters), values={p.name: 1.14 for p in parameters},
    )  # fmt: skip
    done = Some(verdict=verdict, corrected=model, refitted=model, floor=1.0, rounds=rounds)
    return verdict_sentence(
        Some(
            search=done,
            limits=limit,
            recording=recording,
            levels=None,
            taken_back=None,
            only_held_out=only,
            off_pace=False,
            remarks=(),
            empirical=None,
            error_by_stage={"after": held_out or ratio},
            floors=ONES,
            gains=gains,
        )
    )


def test_near_the_floor():
    verdict = judged([], [], [], 1.0, ratio=1.02)
    assert verdict.kind == "nothing missing"
    assert "leaves is noise (1.020 times the floor" in said(verdict, 1.02)


def test_runs_held_out_that_leave_far_more_show_something_of_their_own():
    verdict = judged([], [], [], 1.0, ratio=1.02)
    assert "but it is 4.60 times the floor of noise on runs held out" in said(
        verdict, 1.02, held_out=4.6
    )
    assert "Nothing is missing" in said(verdict, 1.02, held_out=1.4)


def test_what_runs_held_out_alone_show_beyond_noise_cannot_be_told():
    told = said(Verdict("lack or noise"), 1.02, SIMULATED, held_out=1.138, only=True)
    assert "the runs that fit and select show nothing (on the latter the error is 1.02" in told
    assert "but it is 1.138 times the floor of noise on runs held out" in told
    usual = said(Verdict("lack or noise"), 1.02, SIMULATED, held_out=1.138)
    assert "1.02 times on those that select" in usual


def test_what_is_missing_beside_a_refit_that_went_far_is_said_so():
    scale = Parameter("scale", 1.0, 0.5, 1.5, 0.01, tolerance=0.04)
    told = said(Verdict("nothing missing"), 1.0, SIMULATED, parameters=(scale,))
    assert told.startswith("Nothing is missing beside scale +14.0 % (declared to 4 %): what")


def test_well_above_the_floor_of_repeated_runs():
    verdict = judged([], [], [], 1.0, ratio=1.16)
    assert verdict.kind == "unknown"
    assert "2.50 times the floor on the fitted runs and 1.16 times" in said(verdict, 1.16)


def test_noise_that_was_estimated_from_single_runs_is_given_more_room():
    verdict = judged([], [], [], 1.0, ratio=1.16, limit=SINGLE)
    assert verdict.kind == "nothing missing"
    assert "once more, would tell" in said(verdict, 1.16, SINGLE)
    assert "once more, would tell" not in said(verdict, 1.16, known_by_repetition(SINGLE, 1.0, 0.1))


def test_a_repeated_run_is_not_asked_for_where_no_noise_is_so_large():
    unknown = Verdict("unknown")
    assert "once more, would tell" in said(unknown, 9.0, SINGLE)
    assert "once more, would tell" not in said(unknown, 46.0, SINGLE)
    told = SINGLE._replace(told=True)  # a driver's own force may be a hundred times as large
    assert "once more, would tell" in said(unknown, 46.0, told)
    assert "once more, would tell" not in said(unknown, 146.0, told)


def test_what_nothing_drives_is_let_go_once_more():
    alone = Some(map=Some(driven=False))
    assert "let go the same way once more" in said(Verdict("unknown"), 9.0, SINGLE, recording=alone)
    driven = Some(map=Some(driven=True))
    assert "driven the same way" in said(Verdict("unknown"), 9.0, SINGLE, recording=driven)


def test_what_goes_along_with_something_near_the_floor_is_told():
    shown = Some(best=None, trials=[], before={"force": _depends(["heat"])})
    words = said(Verdict("nothing missing"), 1.4, SINGLE, rounds=[shown])
    assert "may be noise so near the floor, though it goes along with heat" in words
    assert "none of the known effects promises enough to be fitted" in words
    assert "nothing that was looked at" in said(Verdict("nothing missing"), 1.4, SINGLE)


@pytest.mark.parametrize(("kind", "told"), [("unknown", "explains it"), ("lack or noise", "helps")])
def test_what_comes_nearest_is_told_with_what_it_takes_away(kind, told):
    near = Some(candidate=Some(name="viscous-drag"), gain=0.204)
    verdict = Verdict(kind, coordinates=("force:position",))
    assert f"none of the known effects {told}" in said(verdict, 2.0)
    nearest = said(verdict, 2.0, rounds=[Some(best=near, trials=[near], before={})])
    assert "effects explains it (viscous-drag, which comes nearest, takes 20 %" in nearest


def test_what_came_after_it_counts_as_well():
    one, other = (Some(candidate=Some(name=n), gain=0.1) for n in ("stribeck", "pull-in"))
    rounds = [Some(best=t, trials=[t], verdict=Verdict("open", t)) for t in (one, other)]
    refused = Some(best=other, trials=[other], verdict=Verdict("unknown"))
    words = said(Verdict("unknown"), 2.0, rounds=[*rounds, refused])
    assert "(stribeck and pull-in, which come nearest, take 19 % of the error" in words


# Noise that lasts seven rows has ten times the slow part of white noise with the same steps,
# whether it is of a drive that was seen or of what is compared.
@pytest.mark.parametrize("limit", [SEEN, SINGLE])
@pytest.mark.parametrize(
    ("ratio", "kind"), [(1.6, "lack or noise"), (9.9, "lack or noise"), (10.1, "unknown")]
)
def test_not_without_end(ratio, kind, limit):
    verdict = judged([], [], [], 1.0, ratio=ratio, limit=limit)
    assert verdict.kind == kind
    assert "nothing that was looked at" in said(verdict, ratio, limit)


def test_what_goes_along_with_the_torque_sooner():
    assert judged([], _depends(["force:torque"]), [], 1.0, ratio=3.8, limit=SEEN).kind == "unknown"


def test_where_runs_were_repeated_their_differences_are_known():
    known = known_by_repetition(SEEN, 1.0, 0.1)
    assert judged([], [], [], 1.0, ratio=1.6, limit=known).kind == "unknown"


@pytest.mark.parametrize(("sure", "kind"), [(0.02, "unknown"), (0.1, "nothing missing")])
def test_as_well_as_their_windows_tell(sure, kind):
    """Three standard errors: 1.16 times a floor known to 2 % is no noise, to 10 % it may be."""
    known = known_by_repetition(SINGLE, 1.0, sure)
    assert judged([], [], [], 1.0, ratio=1.16, limit=known).kind == kind


@pytest.mark.parametrize("before", [SIMULATED, SIMULATED_AXIS])
@pytest.mark.parametrize(("ratio", "kind"), [(1.45, "nothing missing"), (1.55, "lack or noise")])
def test_where_they_differ_by_more_than_noise_nothing_is_missing_up_to_where_it_is_looked_for(
    before, ratio, kind
):
    known = known_by_repetition(before, 1.3, 0.1)
    assert judged([], [], [], 1.0, ratio=ratio, limit=known).kind == kind


@pytest.mark.parametrize(("ratio", "kind"), [(1.09, "nothing missing"), (1.12, "lack or noise")])
def test_beyond_what_nulls_of_a_robot_leave_it_cannot_be_told(ratio, kind):
    assert judged([], [], [], 1.0, ratio=ratio, limit=SIMULATED).kind == kind


@pytest.mark.parametrize(("gain", "kind"), [(0.05, "lack or noise"), (0.15, "unknown")])
def test_a_little_of_it_goes_along_with_anything_by_chance(gain, kind):
    """In single runs of an axis a tenth is asked of a dependence."""
    slip = [Dependence("force:slip_velocity", gain, 0.005, 1000, *np.zeros((3, 1)))]
    limit = SIMULATED_AXIS._replace(drive=True)
    verdict = judged([], slip, [], 1.0, ratio=1.6, limit=limit)
    assert (verdict.kind, verdict.coordinates) == (kind, ("force:slip_velocity",))


def _depends(where):
    return [Dependence(c, 0.5, 0.0, 1000, *np.zeros((3, 1))) for c in where]


@pytest.mark.parametrize(
    ("limit", "where", "kind"),
    [
        (REPEATED, "force:torque", "unknown"),  # repeated runs tell the floor, whatever the noise
        (SINGLE, "force:torque", "unknown"),  # a drive that was told has none
        (SEEN, "force:torque", "lack or noise"),
        (SEEN, "force:acceleration", "lack or noise"),
        (SEEN, "force:position", "unknown"),
        (SEEN, "vibration:torque", "unknown"),
    ],
)
def test_noise_that_is_not_white_is_not_called_a_lack(limit, where, kind):
    verdict = judged([], _depends([where]), [], 1.0, ratio=2.1, limit=limit)
    assert verdict.kind == kind
    assert ("slower than was allowed for" in said(verdict, 2.1, limit)) is (kind == "lack or noise")


@pytest.mark.parametrize(("ratio", "kind"), [(1.02, "nothing missing"), (1.04, "unknown")])
def test_few_blocks_depend_by_chance_at_the_floor_of_a_robot(ratio, kind):
    chance = [Dependence("joint_2:time", 0.138, 0.005, 80, *(np.zeros(1),) * 3)]
    assert judged([], chance, [], 1.0, ratio=ratio, limit=SIMULATED).kind == kind
    assert judged([], chance, [], 1.0, ratio=ratio).kind == "unknown"
