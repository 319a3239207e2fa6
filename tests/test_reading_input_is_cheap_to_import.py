"""``--help`` must not wait for pint, NumPy or SciPy."""

import subprocess
import sys

import pytest


@pytest.mark.parametrize(
    "module", ["units", "problems", "files.tomlkeys", "files.tomlfile", "reading.reader"]
)
def test_imports_nothing_heavy(module):
    code = (
        f"import sys, simpter_hybrid.{module};"
        "print([m for m in ('pint', 'numpy', 'scipy', 'sympy', 'tomli_w') if m in sys.modules])"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"
