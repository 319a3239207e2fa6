"""``python -m derivations --check --audit`` does both, and a stale module decides the exit code."""

import pytest

from derivations import __main__ as command


@pytest.mark.parametrize("stale", [0, 1])
@pytest.mark.parametrize("order", [["--check", "--audit"], ["--audit", "--check"]])
def test_both_are_done(monkeypatch, stale, order):
    done = []
    monkeypatch.setattr(command, "_check", lambda: done.append("check") or stale)
    monkeypatch.setattr(command, "_audit", lambda: done.append("audit"))
    assert command.main(order) == stale
    assert done == ["check", "audit"]
