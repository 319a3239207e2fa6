import pytest

from simpter_hybrid import progress
from simpter_hybrid.identification.fitting.effort import Effort
from simpter_hybrid.progress import Murmur


def test_a_long_search_says_that_it_is_still_at_work(monkeypatch: pytest.MonkeyPatch) -> None:
    now, said = [0.0], []
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    murmur = Murmur(said.append)
    effort = Effort(told=murmur.simulated)
    murmur("refitting")
    effort.add(1e6)
    now[0] = progress.SILENCE + 1.0
    effort.add(2e6)
    effort.add(2e6)
    assert said == ["refitting", "still at it: 3 million steps of simulated runs"]
