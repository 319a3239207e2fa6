"""The dialect's compiler against Python itself, on the same functions and random numbers."""

import ctypes
import inspect
import math
import random

import pytest

pytest.importorskip("llvmlite")
from simpter_hybrid.lowering import module
from simpter_hybrid.lowering.kinds import Unsupported


def whole_numbers(a, b):
    if b == 0:
        return 0.0
    return 1.0 * (a // b) + 0.001 * (a % b) + (a * b - abs(a)) * 0.5


def comparisons(x, y):
    found = 0.0
    if -1.0 < x <= y or not (x == y or y > 2.0):
        found += 1.0
    elif x != y and x < 0.0:
        found -= 2.0
    return found + (3.0 if x > y else -1) + (x > 0.0)


def extremes(x, y):
    return max(x, y, 0.25) - 2.0 * min(x, y) + max(1, int(x)) + float(int(y))


def operands(x, y):
    k = (x > 0.0 and y) or 0.25
    both = x and y and 2
    if not (x or (y > 1.0 and k)):
        both += 1.0
    return k + 10.0 * both + (y or x or 1)


def powers(x, y):
    return x**2 - y**3 + abs(x) ** 1.5 + 2.0**y + x / (1.0 + y * y)


def functions(x, y):
    a = math.sin(x) * math.cos(y) + math.atan2(y, x) + math.hypot(x, y) + math.tanh(x)
    a += math.log(1.0 + y * y) + math.log(1.0 + y * y, 2.0 + x * x)
    return a + math.exp(-abs(x)) + math.floor(x) + x % 0.7 + math.pi


def loops(x, y):
    total = 0
    for i in range(7, 0, -2):
        if i == 3:
            continue
        k = 0
        while True:
            k += 1
            if k * i > 10:
                break
            total += x * k
        total += i
    return total + y


def several(x, y):
    if x > y:
        return x, 1
    return 2, y


def two(x, y):
    a, b = several(x, y)
    a, b = b, a
    return a - 3.0 * b


def arrays(x, y, s):
    part = s[2:4]
    part[0] = x
    part[1] = y
    s[0] = part[0] * 2.0
    s[0] += s[3]
    return s[0] + s[2]


FLOATS = (comparisons, extremes, operands, powers, functions, loops, two)


def compiled(*wanted, kinds):
    space = module.Space()
    for f in {several, *wanted}:
        space.add(inspect.getsource(f))
    translation = module.Translation({}, {}, {})
    translation.export(space, wanted[0].__name__, kinds)
    engine, found = module.callables(module.object_code(translation), [wanted[0].__name__])
    types = {"f": ctypes.c_double, "i": ctypes.c_int64, "A": ctypes.c_void_p}
    call = ctypes.CFUNCTYPE(ctypes.c_double, *(types[k] for k in kinds))(found[0])
    call.engine = engine
    return call


@pytest.mark.parametrize("function", FLOATS, ids=lambda f: f.__name__)
def test_on_floats(function):
    call, rng = compiled(function, kinds=("f", "f")), random.Random(1)
    for _ in range(300):
        x, y = rng.uniform(-4, 4), rng.choice((0.0, 1.0, rng.uniform(-3, 3)))
        # Rounding of library functions only.
        assert call(x, y) == pytest.approx(function(x, y), rel=1e-14, abs=1e-14)


def test_on_whole_numbers():
    call, rng = compiled(whole_numbers, kinds=("i", "i")), random.Random(2)
    for _ in range(500):
        a, b = rng.randrange(-20, 21), rng.randrange(-7, 8)
        assert call(a, b) == pytest.approx(whole_numbers(a, b), rel=1e-15)


def test_slices_are_views():
    call, memory = compiled(arrays, kinds=("f", "f", "A")), (ctypes.c_double * 4)()
    assert call(1.5, 0.25, ctypes.addressof(memory)) == 1.5 * 2 + 0.25 + 1.5
    assert list(memory) == [3.25, 0.0, 1.5, 0.25]


def downwards(x, y):
    step = 0 - 1
    for k in range(5, 0, step):
        x += k
    return x + y


def test_a_loop_whose_direction_is_not_known_beforehand_is_refused():
    with pytest.raises(Unsupported, match=r"the step of range.* is a whole number, written out"):
        compiled(downwards, kinds=("f", "f"))


def too_many(x, y):
    return math.hypot(x, y, 12.0)


def from_the_end(x, y, s):
    return x + y + s[-1]


@pytest.mark.parametrize(
    ("function", "said"),
    [
        (too_many, r"3 arguments where 2 would be right \('math.hypot"),
        (from_the_end, "an index counts from the beginning"),
    ],
)
def test_what_would_mean_something_else_is_refused(function, said):
    with pytest.raises(Unsupported, match=said):
        compiled(function, kinds=("f", "f", "A")[: function.__code__.co_argcount])


def hidden(x, y):
    return max(x, math.sqrt(y), 0.0) + min(math.sqrt(y), x)


def hidden_behind(x, y):
    return min(x, max(0.0, 1.0 + math.sqrt(y)))


@pytest.mark.parametrize("function", [hidden, hidden_behind])
def test_no_extreme_hides_what_python_refuses(function):
    call = compiled(function, kinds=("f", "f"))
    assert math.isnan(call(3.0, -0.1))
    assert call(3.0, 0.25) == function(3.0, 0.25)
