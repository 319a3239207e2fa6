"""Where nothing helps: nothing is missing at the floor, something is well above it."""

from types import SimpleNamespace as Some

import numpy as np
import pytest

from simpter_hybrid.identification.sentences import verdict_sentence
from simpter_hybrid.identification.verdict import (
    OFF_NOISE,
    REPEATED,
    SINGLE,
    Limits,
    Verdict,
    judge,
)


def said(verdict, ratio, limit=REPEATED):
    model = Some(effects=(), select=ratio, residuals=np.full(9, 2.5))
    done = Some(verdict=verdict, corrected=model, declared=model, floor=1.0)
    return verdict_sentence(Some(diagnosis=done, limit=limit))


def test_near_the_floor():
    verdict = judge([], [], [], 1.0, ratio=1.02)
    assert verdict.kind == "nothing missing"
    assert said(verdict, 1.02).endswith("is noise.")


def test_well_above_the_floor_of_repeated_runs():
    verdict = judge([], [], [], 1.0, ratio=1.16)
    assert verdict.kind == "unknown"
    assert "2.50 times the floor on the fitted runs and 1.16 times" in said(verdict, 1.16)


def test_noise_that_was_estimated_from_single_runs_is_given_more_room():
    verdict = judge([], [], [], 1.0, ratio=1.16, limit=Limits(lack=OFF_NOISE))
    assert verdict.kind == "nothing missing"
    assert "repeated runs would tell" in said(verdict, 1.16)


@pytest.mark.parametrize("ratio", [1.6, 3.8])
def test_not_without_end(ratio):
    assert judge([], [], [], 1.0, ratio=ratio, limit=Limits(lack=OFF_NOISE)).kind == "unknown"


def test_a_verdict_without_a_variable_says_so():
    assert "nothing that was looked at" in said(Verdict("unknown"), 3.8)


@pytest.mark.parametrize(
    ("limit", "where", "told"),
    [
        (REPEATED, (), False),  # repeated runs tell the floor, whatever the noise
        (SINGLE, (), True),
        (SINGLE, ("force:torque",), True),
        (SINGLE, ("force:position",), False),
    ],
)
def test_noise_that_is_not_white_is_mentioned_where_it_would_look_so(limit, where, told):
    sentence = said(Verdict("unknown", coordinates=where), 2.1, limit)
    assert ("slower than white noise" in sentence) is told
