"""Python started beside the clone, a folder named simpter_hybrid without a package in it."""

import subprocess
import sys


def test_the_package_is_found_beside_a_folder_of_its_name(tmp_path):
    (tmp_path / "simpter_hybrid").mkdir()
    command = [sys.executable, "-c", "import simpter_hybrid; print(simpter_hybrid.run)"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert "function run" in run.stdout, run.stderr
