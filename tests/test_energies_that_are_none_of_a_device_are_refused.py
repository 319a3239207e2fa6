"""What ``derive_text`` says that it refuses, it refuses: no wrong device, no broken module."""

import pytest
import sympy as sp

from simpter_hybrid.derive import derive_device, derive_text
from simpter_hybrid.device_check import check_device

(X, Y), (V, W) = sp.symbols("x y"), sp.symbols("v w")
M = sp.Symbol("mass")
R = sp.Symbol("x", real=True)
KINETIC = M * (V**2 + W**2) / 2


def made(kinetic=KINETIC, x=X, **options):
    return derive_text("Pair", [x, Y], [V, W], kinetic, {"s": x}, {M: ("mass", 1.0)}, **options)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        (M * Y * V, "linear in v"),
        (M * X**2 * 9 / 2, "is there at rest; take it out and add it to potential"),
        (M * V**4, "quadratic in the speeds"),
    ],
)
def test_a_kinetic_energy_that_is_not_quadratic(more, said):
    with pytest.raises(ValueError, match=f"kinetic energy: .*{said}"):
        made(KINETIC + more)


def test_what_cancels_is_not_there():
    nothing = M * V * (sp.sin(X) ** 2 + sp.cos(X) ** 2 - 1)
    assert "class Pair" in made(KINETIC + nothing)


@pytest.mark.parametrize("option", [{"potential": M * X * V}, {"tip": (X, V)}])
def test_a_pose_that_depends_on_speeds(option):
    with pytest.raises(ValueError, match=f"{next(iter(option))}: it depends on the speeds v"):
        made(**option)


@pytest.mark.parametrize(
    ("potential", "said"),
    [
        (M * sp.Abs(X), "conservative_force: re cannot be written as code.*declared real"),
        (M * sp.Function("f")(X), "cannot be written as code"),
        (M * sp.besselj(0, X), "conservative_force: besselj cannot be written"),
        (M * sp.I * X, "not a finite real number"),
        (M * sp.Sum(sp.Symbol("k") * X, (sp.Symbol("k"), 0, Y)), "cannot be written as code"),
    ],
)
def test_what_no_code_can_say(potential, said):
    with pytest.raises(ValueError, match=said):
        made(potential=potential)


@pytest.mark.parametrize(
    "potential", [sp.Abs(R), sp.Max(R, 0) ** 2, sp.erf(R), sp.Piecewise((R**2, R > 0), (0, True))]
)
def test_what_code_can_say(potential):
    device = derive_device(
        "Own", [R], [V], M * V**2, {"s": R}, {M: ("mass", 1.0)}, potential=potential
    )
    assert check_device(device, [(0.3,)]) == []


@pytest.mark.parametrize(
    "title",
    ['a """ quote', 'ends with "', 'ends with """', "a \\N path", "ends with \\", 'so "it"'],
)
def test_a_title_is_kept_as_it_is(title):
    scope = {"__name__": "made"}
    exec(compile(made(title=title), "made", "exec"), scope)
    assert scope["Pair"].__doc__ == title
