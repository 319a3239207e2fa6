"""Sine and cosine of compiled code against 60 digits, and at numbers that are none."""

import ctypes
import math
import random

import mpmath
import pytest

pytest.importorskip("llvmlite")
from simpter_hybrid.lowering import module

TEXT = "def sine(x):\n    return sin(x)\n\ndef cosine(x):\n    return cos(x)\n"
#: Units in the last place; 0.5 is rounding itself.
ULPS = 1.5
#: What a quarter turn in two parts leaves out of a thousand turns, beside a function's zeros.
LOST = 1e-28


@pytest.fixture(scope="module")
def functions():
    space = module.Space()
    space.add(TEXT)
    translation = module.Translation({}, {}, {})
    for name in ("sine", "cosine"):
        translation.export(space, name, ("f",))
    code, addresses = module.callables(module.object_code(translation), ["sine", "cosine"])
    kind = ctypes.CFUNCTYPE(ctypes.c_double, ctypes.c_double)
    yield [kind(address) for address in addresses]
    del code


def arguments():
    rng = random.Random(1)
    spans = (1e-8, 1.0, 7.0, 1e3, 9.9e5)
    found = [rng.uniform(-span, span) for span in spans for _ in range(600)]
    # Beside multiples of a quarter turn nearly everything cancels.
    return found + [k * math.pi / 4 for k in range(-1500, 1501, 7)] + [0.0, 5e-324]


@pytest.mark.parametrize("which", [0, 1])
def test_at_thousands_of_angles(functions, which):
    exact = (mpmath.sin, mpmath.cos)[which]
    with mpmath.workdps(60):
        for x in arguments():
            want = exact(mpmath.mpf(x))
            error = abs(mpmath.mpf(functions[which](x)) - want)
            assert error <= ULPS * math.ulp(float(want)) + LOST, x


def test_what_lies_outside_is_the_librarys(functions):
    sine, cosine = functions
    assert (sine(1e22), cosine(-3e6)) == (math.sin(1e22), math.cos(-3e6))
    assert math.isnan(sine(math.inf))
    assert math.isnan(cosine(math.nan))
    assert sine(-0.0) == 0.0
