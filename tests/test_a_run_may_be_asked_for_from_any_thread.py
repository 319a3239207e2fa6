"""Only the main thread hears signals; what runs elsewhere goes without them."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from simpter_hybrid.cli import main


def test_a_run_may_be_asked_for_from_any_thread(tmp_path: Path) -> None:
    asked = ["run", "testbed-step-0-8", "--no-report", "--quiet", "--out", str(tmp_path / "out")]
    with ThreadPoolExecutor(1) as threads:
        assert threads.submit(main, asked).result() == 0
