"""What a full disk or a power cut leaves of a kept file is not run: that would end the program."""

import pytest

from simpter_hybrid.machine_code.compiling import DIGEST, kept

CODE = b"machine code of some length"


@pytest.mark.parametrize("left", [0, DIGEST, len(CODE), len(CODE) + DIGEST - 1])
def test_a_file_that_is_not_whole_is_replaced(tmp_path, monkeypatch, left):
    monkeypatch.setenv("SIMPTER_CACHE", str(tmp_path))
    made = []

    def make():
        made.append(1)
        return CODE

    assert kept("own", make) == kept("own", make) == CODE
    assert len(made) == 1
    (file,) = tmp_path.rglob("*.o")
    file.write_bytes(file.read_bytes()[:left])
    assert kept("own", make) == kept("own", make) == CODE
    assert len(made) == 2
    assert list(tmp_path.rglob("*.tmp")) == []
