"""Command line: ``python -m derivations [--check] [--audit]``.

Exit codes: 0 done or fresh, 1 a generated module is stale.
"""

from __future__ import annotations

import argparse
import sys


def main(argv: list[str] | None = None) -> int:
    """Write the generated modules, check them, or audit the thesis."""
    parser = argparse.ArgumentParser(
        prog="python -m derivations",
        description="Derive PTER's equations and write the generated modules.",
    )
    parser.add_argument(
        "--check", action="store_true", help="compare with the committed modules; 1 if stale"
    )
    parser.add_argument(
        "--audit", action="store_true", help="compare with the thesis, write AUDIT.md, print it"
    )
    chosen = parser.parse_args(argv)
    if chosen.check or chosen.audit:
        stale = _check() if chosen.check else 0
        if chosen.audit:
            _audit()
        return stale
    from derivations import modules

    for path in modules.write():
        print(f"wrote {path.parent.name}/{path.name}", file=sys.stderr)
    return 0


def _check() -> int:
    import sympy

    from derivations import modules

    findings = modules.stale()
    if not findings:
        return 0
    sys.stdout.write("".join(findings))
    for committed in sorted(modules.committed_sympy_versions() - {sympy.__version__}):
        print(
            f"note: the committed modules are from SymPy {committed}, here is {sympy.__version__}: "
            "the same equations may be written differently",
            file=sys.stderr,
        )
    print("stale generated modules: run `python -m derivations` and commit them", file=sys.stderr)
    return 1


def _audit() -> None:
    from derivations.audit import report

    sys.stdout.write(report.write())


if __name__ == "__main__":
    sys.exit(main())
