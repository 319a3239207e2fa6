"""``--help`` and ``list`` answer at once: they import neither NumPy nor anything slower."""

import subprocess
import sys

import pytest

SLOW = ("numpy", "scipy", "sympy", "matplotlib", "pint", "numba")


@pytest.mark.parametrize("arguments", [["--help"], ["list"], ["run", "--help"], ["list", "--json"]])
def test_no_slow_module(arguments):
    code = (
        "import sys\nfrom simpter_hybrid.cli import main\n"
        f"try: main({arguments!r})\nexcept SystemExit: pass\n"
        f"print([m for m in {SLOW!r} if m in sys.modules])"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip().split("\n")[-1] == "[]"


def test_the_package_itself_is_light():
    code = f"import sys, simpter_hybrid; print([m for m in {SLOW!r} if m in sys.modules])"
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert out.stdout.strip() == "[]"
