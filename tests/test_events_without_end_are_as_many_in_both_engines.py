"""Zeno: 40 + 10 m events within 1e-9 s, the first and the last of them counted."""

import pytest

from simpter_hybrid.kernel.records import events_at_once
from simpter_hybrid.kernel.rules import AT_ONCE, zeno


@pytest.mark.parametrize("m", [1, 4])
@pytest.mark.parametrize(("part", "ended"), [(0.99, True), (1.01, False)])
def test_so_many_events_within_an_instant_have_no_end(m, part, ended):
    most = events_at_once(m)
    step = part * AT_ONCE / (most - 1)  # so that `most` events last just less, or more, than it
    recent = [0.0] * most
    found = [zeno(m, k * step, k, recent) for k in range(1, most + 1)]
    assert not any(found[:-1])
    assert found[-1] == ended
