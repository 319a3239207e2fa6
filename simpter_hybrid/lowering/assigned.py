"""Variables that are read where no path has given them a value: Python stops there, code does not.

A branch's own variable would read what an earlier call has left in its place.
"""

from __future__ import annotations

import ast

from .kinds import Unsupported

#: Names that have a value; None where no path leads.
Known = frozenset[str] | None


def check_assigned(source: ast.FunctionDef) -> None:
    """Refuse a function that reads a variable which some path to it has not assigned.

    Parameters
    ----------
    source : FunctionDef

    Raises
    ------
    Unsupported
        With the variable's name.
    """
    Paths(source).block(source.body, frozenset(a.arg for a in source.args.args))


def both(a: Known, b: Known) -> Known:
    """What is known where two paths meet."""
    if a is None or b is None:
        return b if a is None else a
    return a & b


class Paths:
    """Follows a function's paths; ``loops`` collects what is known where loops are left or go on.

    Parameters
    ----------
    source : FunctionDef
    """

    def __init__(self, source: ast.FunctionDef) -> None:
        names = (x for x in ast.walk(source) if isinstance(x, ast.Name))
        self.own = {x.id for x in names if isinstance(x.ctx, ast.Store)}
        self.loops: list[list[Known]] = []

    def read(self, node: ast.AST, known: frozenset[str]) -> None:
        """Look at an expression.

        Raises
        ------
        Unsupported
            If it reads a variable that is not known to have a value.
        """
        for x in ast.walk(node):
            if isinstance(x, ast.Name) and isinstance(x.ctx, ast.Load):
                self.name(x, known)

    def name(self, x: ast.Name, known: frozenset[str]) -> None:
        """Look at a variable that is read.

        Raises
        ------
        Unsupported
            If it is not known to have a value.
        """
        if x.id in self.own and x.id not in known:
            raise Unsupported(
                f"the variable {x.id!r} has no value on some path to where it is read; "
                "give it one before the branch or loop that assigns it"
            )

    def block(self, statements: list[ast.stmt], known: Known) -> Known:
        """What is known after statements."""
        for s in statements:
            if known is None:
                return None
            known = self.statement(s, known)
        return known

    def statement(self, s: ast.stmt, known: frozenset[str]) -> Known:
        """What is known after a statement."""
        if isinstance(s, ast.If):
            self.read(s.test, known)
            return both(self.block(s.body, known), self.block(s.orelse, known))
        if isinstance(s, ast.While | ast.For):
            return self.loop(s, known)
        if isinstance(s, ast.Break | ast.Continue):
            self.loops[-1 if isinstance(s, ast.Break) else -2].append(known)
            return None
        if isinstance(s, ast.AugAssign) and isinstance(s.target, ast.Name):
            self.name(s.target, known)
        self.read(s, known)
        names = (x for x in ast.walk(s) if isinstance(x, ast.Name))
        stored = {x.id for x in names if isinstance(x.ctx, ast.Store)}
        return None if isinstance(s, ast.Return) else known | stored

    def loop(self, s: ast.While | ast.For, known: frozenset[str]) -> Known:
        """What is known after a loop, whose body may not run unless the text says that it does."""
        inner = known
        if isinstance(s, ast.For):
            self.read(s.iter, known)
            inner = known | {x.id for x in ast.walk(s.target) if isinstance(x, ast.Name)}
        else:
            self.read(s.test, known)
        again: list[Known] = []
        left: list[Known] = []
        self.loops += [again, left]
        again.append(self.block(s.body, inner))
        del self.loops[-2:]
        if isinstance(s, ast.For):
            left += again if runs(s.iter) else [known]
        elif not isinstance(s.test, ast.Constant):
            left.append(known)
        found: Known = None
        for one in left:
            found = both(found, one)
        return found


def runs(over: ast.expr) -> bool:
    """Whether a ``range(...)`` is written out in numbers and not empty."""
    try:
        bounds = [ast.literal_eval(a) for a in getattr(over, "args", ())]
        return len(range(*bounds)) > 0
    except (ValueError, TypeError):
        return False
