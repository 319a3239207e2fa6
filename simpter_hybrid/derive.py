"""A device from its energies: symbols in, a class with committed-quality code out."""

from __future__ import annotations

import linecache
import sys
import textwrap
from collections.abc import Mapping, Sequence
from dataclasses import fields
from hashlib import sha256
from types import ModuleType
from typing import Any

from .derive_check import (
    check_counts,
    check_dimensions,
    check_fields,
    check_functions,
    check_kinetic,
    check_locals,
    check_names,
    check_real,
    check_symbols,
    check_without_speeds,
    escaped,
    not_written,
)
from .device import Device

#: A method to be written: its name, its arguments, what it computes and what is said of that.
Piece = tuple[str, tuple[str, ...], Any, str]
HEAD = '''"""{title}

Derived from its kinetic and potential energy; regenerate rather than edit.
"""

import math
from dataclasses import dataclass
from math import *
from typing import ClassVar

from simpter_hybrid.device import Device
from simpter_hybrid.part import parameter


@dataclass(frozen=True)
class {name}(Device):
    """{title}"""

{fields}
    coordinates: ClassVar[tuple[str, ...]] = {coordinates!r}
    coordinate_dimensions: ClassVar[tuple[str, ...]] = {dimensions!r}
    surfaces: ClassVar[tuple[str, ...]] = {surfaces!r}
    constant_clutch_map: ClassVar[bool] = {constant}
'''


def derive_text(
    name: str,
    coordinates: Sequence[Any],
    speeds: Sequence[Any],
    kinetic: Any,
    slips: Mapping[str, Any],
    parameters: Mapping[Any, tuple[str, float]],
    *,
    potential: Any = 0,
    tip: Sequence[Any] = (),
    dimensions: Sequence[str] = (),
    title: str = "",
) -> str:
    """Source of a module with a device class ``name``, to be written to a file and used from there.

    Parameters
    ----------
    name : str
        Of the class.
    coordinates, speeds : sequences of sympy.Symbol, (n,)
        Generalized coordinates and their rates, as the energies use them.
    kinetic, potential : sympy expressions
        [J]; the kinetic energy is quadratic in the speeds.
    slips : mapping of str to sympy expression
        Name of every friction surface and its slip angle (or slip distance) as a function of the
        coordinates, or its slip velocity, linear in the speeds.
    parameters : mapping of sympy.Symbol to (str, float)
        Dimension and value of every other symbol.
    tip : sequence of two sympy expressions, optional
        Coordinates of the tip [m].
    dimensions : sequence of str, optional
        ``angle`` or ``length`` for every coordinate.
    title : str
        A line that says what it is.

    Raises
    ------
    ValueError
        If a symbol is not declared, the kinetic energy is not quadratic, potential or tip depend on
        speeds, a slip velocity is not linear in them, a coordinate is said to measure something
        else, or an expression cannot be written as code.
    """
    import sympy as sp

    from derivations.lagrangian import lagrange

    q, qd = sp.Matrix(list(coordinates)), sp.Matrix(list(speeds))
    check_counts(coordinates, speeds, parameters)
    check_names(name, [*coordinates, *parameters], slips)
    check_fields(parameters)
    check_dimensions(dimensions, len(q))
    check_symbols([kinetic, potential, *slips.values(), *tip], [*q, *qd, *parameters])
    check_without_speeds("potential", [potential], speeds)
    check_without_speeds("tip", tip, speeds)
    motion = lagrange(sp.sympify(kinetic), q, qd)
    check_kinetic(sp.sympify(kinetic), speeds)
    C = sp.Matrix([_row(surface, slip, q, qd) for surface, slip in slips.items()])
    if not slips:
        C = sp.zeros(0, len(q))
    bindings = {s: f"q[{j}]" for j, s in enumerate(q)}
    bindings |= {s: f"qd[{j}]" for j, s in enumerate(qd)}
    bindings |= {s: f"p[{k}]" for k, s in enumerate(parameters)}
    potential = sp.sympify(potential)
    pieces: list[Piece] = [
        ("mass_matrix", ("q", "p"), motion.mass_matrix, "M, n*n."),
        ("velocity_terms", ("q", "qd", "p"), motion.velocity_terms, "V, n."),
        ("clutch_map", ("q", "p"), C, "C, m*n."),
        ("clutch_map_rate", ("q", "qd", "p"), (C * qd).jacobian(q) * qd, "Cdot qd, m."),
        *(_of_potential(potential, q) if potential != 0 else ()),
        *(_of_tip(tip, q, qd) if tip else ()),
    ]
    methods = [_method(piece, bindings) for piece in pieces]
    check_locals(bindings, methods, pieces)
    text = HEAD.format(
        title=escaped(title or f"{name}."), name=name, fields=_fields(parameters),
        coordinates=tuple(str(s) for s in coordinates), surfaces=tuple(slips),
        dimensions=tuple(dimensions), constant=not C.free_symbols & set(q),
    )  # fmt: skip
    return text + "".join(methods)


def _method(piece: Piece, bindings: Mapping[Any, str]) -> str:
    """The text of a method."""
    import sympy as sp

    from derivations.codegen import Function, function_text

    name, arguments, expressions, doc = piece
    into = "" if name == "potential_energy" else "out"
    outputs = tuple(expressions) or (sp.S.Zero,)
    arguments = (*arguments, *((into,) if into else ()))
    check_real(name, outputs)
    try:
        made = function_text(Function(name, arguments, doc, bindings, outputs, into))
    except NotImplementedError as error:  # SymPy's printer ends its first line with what it is
        raise not_written(name, str(error).split("\n")[0].rpartition(": ")[2]) from None
    except ValueError:  # so the printer answers to one of what it does not know
        raise not_written(name, "a derivative that SymPy leaves undone") from None
    check_functions(name, made)
    return "\n    @staticmethod\n" + textwrap.indent(made, "    ")


def _of_potential(potential: Any, q: Any) -> list[Piece]:
    """The methods of a device that has a potential energy."""
    import sympy as sp

    force = -sp.Matrix([potential]).jacobian(q)
    return [
        ("conservative_force", ("q", "p"), force, "-dU/dq, n."),
        ("potential_energy", ("q", "p"), sp.Matrix([potential]), "U [J]."),
    ]


def _of_tip(tip: Sequence[Any], q: Any, qd: Any) -> list[Piece]:
    """The methods of a device that has a tip."""
    import sympy as sp

    J = sp.Matrix(list(tip)).jacobian(q)
    return [
        ("tip", ("q", "p"), sp.Matrix(list(tip)), "Tip, 2."),
        ("tip_jacobian", ("q", "p"), J, "Its Jacobian, 2*n."),
        ("tip_jacobian_rate", ("q", "qd", "p"), (J * qd).jacobian(q) * qd, "Jdot qd, 2."),
    ]


def derive_device(name: str, *arguments: Any, **options: Any) -> Device:
    """An object of the class that ``derive_text`` writes, with the parameters' values.

    Takes the arguments of ``derive_text``, whose help says what they are. For a scenario file write
    the text that it gives to a module beside the file (``pendulum.py``) and name the class there,
    ``kind = "pendulum:Pendulum"``; see docs/your-own-device.md.

    Parameters
    ----------
    name : str
        Of the class.
    *arguments, **options
        Those of ``derive_text``.

    Raises
    ------
    ValueError
        See ``derive_text``.
    """
    return load_text(derive_text(name, *arguments, **options), name)()


def load_text(text: str, name: str) -> type[Device]:
    """The class ``name`` of a module's text; its source can be read like that of a file.

    Parameters
    ----------
    text : str
        A module, executed as it is.
    name : str
        Of the class in it.
    """
    # Of two devices of one name either keeps its own source.
    digest = sha256(text.encode()).hexdigest()[:16]
    place = f"<derived {name} {digest}>"
    module = ModuleType(f"derived_{name}_{digest}")
    if module.__name__ in sys.modules:
        return getattr(sys.modules[module.__name__], name)
    # Dataclasses look their module up; inspect reads sources through linecache.
    sys.modules[module.__name__] = module
    linecache.cache[place] = (len(text), None, text.splitlines(keepends=True), place)
    try:
        exec(compile(text, place, "exec"), vars(module))
    except BaseException:
        del sys.modules[module.__name__]
        raise
    made = getattr(module, name)

    def reduced(device: Device) -> tuple[Any, ...]:
        if type(device) is not made:  # a class of its own: its module has it
            return _of_class, (type(device), dict(vars(device)))
        return _again, (text, name, {f.name: getattr(device, f.name) for f in fields(device)})

    made.__reduce__ = reduced  # another process has no such module: it gets the text
    return made


def _of_class(kind: type[Device], values: Mapping[str, Any]) -> Device:
    """A device of a class that can be imported."""
    device = kind.__new__(kind)
    vars(device).update(values)
    return device


def _again(text: str, name: str, values: Mapping[str, float]) -> Device:
    """A device from its text, in whatever process."""
    return load_text(text, name)(**values)


def _row(surface: str, slip: Any, q: Any, qd: Any) -> list[Any]:
    """Row of the clutch map of a slip angle, or of a slip velocity."""
    import sympy as sp

    slip = sp.sympify(slip)
    if not slip.free_symbols & set(qd):
        return list(sp.Matrix([slip]).jacobian(q))
    row = sp.Matrix([slip]).jacobian(qd)
    if row.free_symbols & set(qd) or sp.simplify(slip - (row * qd)[0]) != 0:
        raise ValueError(
            f"slip of {surface!r}: {slip} is not linear in the speeds; give the slip angle as a "
            "function of the coordinates, or a velocity linear in the speeds"
        )
    return list(row)


def _fields(parameters: Mapping[Any, tuple[str, float]]) -> str:
    return "".join(
        f'    {symbol}: float = parameter("{dimension}", {float(value)!r})\n'
        for symbol, (dimension, value) in parameters.items()
    )
