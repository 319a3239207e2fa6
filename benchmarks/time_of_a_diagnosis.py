"""How long `simpter diagnose` takes from command to report, recording by recording.

    python benchmarks/time_of_a_diagnosis.py                     # the testbed's practice recordings
    python benchmarks/time_of_a_diagnosis.py testbed/sealed --only T09 T24

Three minutes on two cores are asked of a recording of the testbed (four batteries, 540 s at 500
Hz).  Nothing else should run meanwhile; machine code is kept, so the first one may take longer.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time

from measured import recordings

#: What is asked [s].
MOST = 180.0


def main() -> None:
    """Print a line a recording; exit with 1 if one took longer than asked."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", default="testbed/practice")
    parser.add_argument("--only", nargs="*", default=[], help="names of files")
    args = parser.parse_args()
    model, late = args.folder.split("/")[0], 0
    for file in recordings(args.folder):
        name = file.name.split(".")[0]
        if args.only and name not in args.only:
            continue
        with tempfile.TemporaryDirectory() as folder:
            command = ["-m", "simpter_hybrid", "diagnose", str(file), "--model", model]
            began = time.monotonic()
            done = subprocess.run(
                [sys.executable, *command, "--out", f"{folder}/report"],
                capture_output=True, text=True,
            )  # fmt: skip
            took = time.monotonic() - began
        late += took > MOST or done.returncode != 0
        said = done.stdout.splitlines()[0] if done.stdout else done.stderr[-200:]
        print(f"{name}: {took:.0f} s, asked {MOST:.0f} s; {said[:90]}", flush=True)
    print(f"{late} took longer or failed, on {os.cpu_count()} cores")
    sys.exit(1 if late else 0)


if __name__ == "__main__":
    main()
