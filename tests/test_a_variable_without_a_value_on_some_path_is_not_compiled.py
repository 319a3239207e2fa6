"""Python stops where a variable has no value; machine code would read what an earlier call left."""

import ast
import inspect

import pytest

pytest.importorskip("llvmlite")
from simpter_hybrid.lowering.assigned import check_assigned
from simpter_hybrid.lowering.kinds import Unsupported


def in_one_branch(x):
    if x < 0.5:
        k = x
    return k


def in_a_loop_that_may_not_run(x, count):
    for _ in range(count):
        k = x
    return k


def added_to(x):
    if x < 0.5:
        k = 1.0
    k += x
    return k


def before_the_loop_has_come_round(x):
    total = 0.0
    for i in range(3):
        if i > 0:
            total += k  # noqa: F821
        k = x  # noqa: F841
    return total


def in_both_branches(x):
    if x < 0.5:
        k = x
    elif x < 0.7:
        return x
    else:
        k = 1.0
    return k


def in_loops_that_run(x):
    for i in range(3):
        if i == 1:
            continue
        if x > 2.0:
            break
    while True:
        last = x
        if x > 0.0:
            break
    return last + i


def tree(function):
    return ast.parse(inspect.getsource(function)).body[0]


@pytest.mark.parametrize(
    "function",
    [in_one_branch, in_a_loop_that_may_not_run, added_to, before_the_loop_has_come_round],
    ids=lambda f: f.__name__,
)
def test_it_is_refused(function):
    with pytest.raises(Unsupported, match=r"'k' has no value on some path.* give it one before"):
        check_assigned(tree(function))


@pytest.mark.parametrize("function", [in_both_branches, in_loops_that_run])
def test_what_has_one_on_every_path_is_taken(function):
    check_assigned(tree(function))
