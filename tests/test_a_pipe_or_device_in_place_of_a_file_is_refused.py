"""A FIFO would be waited for and /dev/zero read without end: both are refused before opening."""

import os
import signal

import pytest

from simpter_hybrid.cli import main


@pytest.fixture(params=["fifo", "/dev/null"])
def special(request, tmp_path):
    """A name that is none of a file; whoever opens the FIFO is woken after 20 s, and fails."""
    if request.param == "fifo":
        os.mkfifo(tmp_path / "fifo")
    before = signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.alarm(20)
    yield str(tmp_path / request.param)
    signal.alarm(0)
    signal.signal(signal.SIGALRM, before)


@pytest.mark.parametrize(
    "command",
    [
        "check SPECIAL",
        "diagnose SPECIAL --model emps --quiet --out OUT",
        "sweep reduced-clutch-1 --cases SPECIAL --out OUT --quiet",
    ],
    ids=lambda text: text.split()[0],
)
def test_a_pipe_or_device_is_refused(command, special, tmp_path, capsys):
    given = {"SPECIAL": special, "OUT": str(tmp_path / "out")}
    assert main([given.get(word, word) for word in command.split()]) == 2
    assert "a pipe or device, not a file" in capsys.readouterr().err
    assert not (tmp_path / "out").exists()
