"""The generated modules: their text, writing them, comparing them with what is committed."""

from __future__ import annotations

import difflib
from pathlib import Path

from derivations import equations, reduced_equations
from derivations.codegen import function_text, imports_text
from derivations.provenance import banner, split_banner

DEVICES = Path(__file__).resolve().parent.parent / "simpter_hybrid" / "devices"


def _assemble(header: str, parts: list[str], footer: str = "") -> str:
    body = "\n\n".join(part.strip("\n") + "\n" for part in parts)
    imports = imports_text(body + footer)
    text = banner() + header + "\n" + imports + ("\n\n" if imports else "\n") + body
    return text + ("\n\n" + footer if footer else "")


def equations_text() -> str:
    """Text of ``simpter_hybrid/devices/pter_equations.py``."""
    parts = [function_text(function) for function in equations.functions()]
    return _assemble(
        equations.HEADER,
        [*parts, equations.INVERSE_KINEMATICS],
        f"PARAMETER_ORDER = {equations.PARAMETER_ORDER!r}\n".replace("'", '"'),
    )


def reduced_text() -> str:
    """Text of ``simpter_hybrid/devices/pter_reduced.py``."""
    functions = [
        *reduced_equations.flow_functions(),
        *reduced_equations.hold_functions(),
        *reduced_equations.margin_functions(),
    ]
    parts = [function_text(function) for function in functions]
    return _assemble(reduced_equations.HEADER, parts, reduced_equations.tables_text())


def texts() -> dict[Path, str]:
    """Every generated module: its path and the text it should have."""
    return {
        DEVICES / "pter_equations.py": equations_text(),
        DEVICES / "pter_reduced.py": reduced_text(),
    }


def write() -> list[Path]:
    """Write the generated modules; returns the paths."""
    written = []
    for path, text in texts().items():
        path.write_text(text, encoding="utf-8", newline="\n")
        written.append(path)
    return written


def stale() -> list[str]:
    """Findings, one text per stale module (a unified diff or what the banner says); [] if fresh."""
    findings = []
    for path, fresh in texts().items():
        committed = path.read_text(encoding="utf-8") if path.exists() else ""
        old_banner, old_body = split_banner(committed)
        new_banner, new_body = split_banner(fresh)
        name = f"{path.parent.parent.name}/{path.parent.name}/{path.name}"
        if old_body != new_body:
            findings.append(
                "".join(
                    difflib.unified_diff(
                        committed.splitlines(keepends=True),
                        fresh.splitlines(keepends=True),
                        f"{name} (committed)",
                        f"{name} (derived now)",
                    )
                )
            )
        elif _hash_line(old_banner) != _hash_line(new_banner):
            findings.append(f"{name}: equations unchanged, but the banner names older sources\n")
    return findings


def _hash_line(text: str) -> str:
    return next((line for line in text.splitlines() if "sha256" in line), "")


def committed_sympy_versions() -> set[str]:
    """SymPy versions named by the banners of the committed modules."""
    versions = set()
    for path in texts():
        if path.exists():
            for line in split_banner(path.read_text(encoding="utf-8"))[0].splitlines():
                if line.startswith("# sympy "):
                    versions.add(line.removeprefix("# sympy "))
    return versions
