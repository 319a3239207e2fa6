"""`dump_toml` writes what `tomllib` reads back, and the same bytes every time."""

import tomllib

import pytest
from hypothesis import given
from hypothesis import strategies as st

from simpter_hybrid.files.tomlfile import dump_toml

KEYS = st.text(max_size=5)
VALUES = st.recursive(
    st.floats(allow_nan=False, allow_infinity=False)
    | st.integers(-(2**63), 2**63 - 1)
    | st.booleans()
    | st.text(),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(KEYS, inner, max_size=3),
    max_leaves=10,
)


@given(st.dictionaries(KEYS, VALUES, max_size=4))
def test_round_trip(data):
    text = dump_toml(data)
    assert tomllib.loads(text) == data
    assert dump_toml(tomllib.loads(text)) == text


@pytest.mark.parametrize("wrong", [float("nan"), float("-inf")])
def test_what_is_not_finite_is_not_written(wrong):
    with pytest.raises(ValueError, match=r"effects\.0\.rise"):
        dump_toml({"effects": [{"rise": wrong}]})
