import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from simpter_hybrid.identification.fitting.repeats import ALIKE, same_course

TIME = np.linspace(0.0, 4.0, 801)


def course(size=1.0, offset=0.0, rows=801):
    wave = size * np.sin(3.0 * TIME)
    return {"position": (wave + offset)[:rows], "force": (2.0 * wave)[:rows]}


@given(st.floats(-100.0, 100.0))
def test_a_position_has_no_zero(offset):
    assert same_course(course(), course(offset=offset)) == (abs(offset) < ALIKE * 0.5)


def test_noise_and_a_few_rows_more_make_no_other_course():
    noisy = course(rows=795)
    noisy["force"] = noisy["force"] + 0.05 * np.random.default_rng(1).standard_normal(795)
    assert same_course(course(), noisy)


@pytest.mark.parametrize(
    "other",
    [course(size=1.3), course(rows=700), {"position": course()["position"]}],
    ids=["larger", "shorter", "another channel"],
)
def test_what_was_driven_otherwise_is_another(other):
    assert not same_course(course(), other)
