"""Write docs/studies.md and its pictures: every study with its usual size (some minutes).

    python docs/studies_page.py [--check]

``--check`` only says which files are not what the program makes now.
"""

from __future__ import annotations

import sys
from pathlib import Path

from simpter_hybrid.plots.style import png
from simpter_hybrid.studies import STUDIES, study
from simpter_hybrid.studies.page import markdown

DOCS = Path(__file__).resolve().parent
COMMAND = "python docs/studies_page.py"


def main() -> int:
    """Write or check the page."""
    done = {}
    for name in STUDIES:
        print(f"{name} ...", file=sys.stderr, flush=True)
        done[name] = study(name)
    files = {DOCS / "studies" / f"{n}.png": png(s.picture()) for n, s in done.items() if s.picture}
    page = markdown(done, None, "studies/", COMMAND)
    files[DOCS / "studies.md"] = page.encode()
    if "--check" in sys.argv[1:]:
        stale = [f for f, made in files.items() if not f.is_file() or f.read_bytes() != made]
        told = f"stale: {', '.join(f.name for f in stale)}; run {COMMAND}"
        print(told if stale else "fresh")
        return 1 if stale else 0
    for file, made in files.items():
        file.parent.mkdir(exist_ok=True)
        file.write_bytes(made)
    return 0


if __name__ == "__main__":
    sys.exit(main())
