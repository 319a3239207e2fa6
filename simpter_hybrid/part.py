"""What is plugged in: small frozen objects whose methods are plain scalar functions.

A part is a frozen dataclass.  Its ``float`` fields are its parameters; its functions are
``staticmethod``s whose arguments are wired **by name**: a parameter's name, a signal's name
(``time``, ``speed``, ``excitation`` ...), a state's name.  The functions use only arithmetic,
``math`` and their arguments, so that the same text runs as Python and compiled.
"""

from __future__ import annotations

import dataclasses
import functools
import inspect
import textwrap
from collections.abc import Callable, Sequence
from typing import Any, ClassVar

from .known_units import BY_COORDINATE, DIMENSIONS, unknown_in


def parameter(
    dimension: str,
    default: float | None = None,
    *,
    low: float | None = None,
    high: float | None = None,
    above: float | None = None,
    typical: float | None = None,
    source: str = "",
) -> Any:
    """A dataclass field that is a parameter of a part.

    Parameters
    ----------
    dimension : str
        Dimension name as in ``units`` (``"torque"``, ``"torque/voltage^2"`` ...); values are SI.
    default : float, optional
        Default [SI]; required when None.
    low, high, above : float, optional
        Bounds [SI]; ``low`` and ``high`` are allowed, ``above`` is not.
    typical : float, optional
        Typical size of a change worth looking for [SI] (scaling of fits).
    source : str
        Equation or paper.

    Raises
    ------
    ValueError
        If there is no such dimension.
    """
    check_dimension(dimension)
    metadata = {
        "dimension": dimension, "low": low, "high": high, "above": above, "typical": typical,
        "source": source,
    }  # fmt: skip
    if default is None:
        return dataclasses.field(metadata=metadata)
    return dataclasses.field(default=default, metadata=metadata)


def rows(*columns: tuple[str, str], default: tuple | None = None) -> Any:
    """A dataclass field that is a table: a tuple of rows of floats [SI].

    Parameters
    ----------
    columns : (str, str)
        Name and dimension of every column, e.g. ``("time", "time"), ("torque", "torque")``.
    default : tuple, optional
        Required when None.
    """
    for _, dimension in columns:
        check_dimension(dimension)
    metadata = {"columns": columns}
    if default is None:
        return dataclasses.field(metadata=metadata)
    return dataclasses.field(default=default, metadata=metadata)


def check_dimension(dimension: str) -> None:
    """Check that a quantity of this dimension can be read from a file.

    Parameters
    ----------
    dimension : str
        As for `parameter`.

    Raises
    ------
    ValueError
        If a word of it is not a dimension or unit that is known.
    """
    if unknown := unknown_in(dimension):
        known = ", ".join((*DIMENSIONS, *BY_COORDINATE))
        raise ValueError(
            f"no dimension {unknown[0]!r} (in {dimension!r}); known: {known}, and their products "
            'and quotients ("torque/voltage^2"), also of SI units ("1/s")'
        )


def counted(points: Sequence[Sequence[float]]) -> tuple[float, ...]:
    """Number of points, then the points: how a part keeps them in its ``table``.

    Parameters
    ----------
    points : sequence of sequence of float
        Rows of one length.
    """
    return (float(len(points)), *(v for point in points for v in point))


def index(of: str, default: float | None = None) -> Any:
    """A ``float`` field that holds the number, from 0, of a ``"clutch"`` or a ``"coordinate"``.

    Files name a clutch by its number from 1 and a coordinate by its name.

    Parameters
    ----------
    of : str
        ``clutch`` or ``coordinate``.
    default : float, optional
        Required when None.
    """
    if default is None:
        return dataclasses.field(metadata={"index": of})
    return dataclasses.field(default=default, metadata={"index": of})


@dataclasses.dataclass(frozen=True)
class Part:
    """Base of everything that is plugged into a model."""

    #: Plain functions that the part's functions call; their names must be unique in a model.
    uses: ClassVar[tuple[Callable, ...]] = ()
    #: Whether it plays back a recorded run (``Scenario.rec``), which no file has.
    plays_recording: ClassVar[bool] = False
    #: Whether its forces and speeds are those of friction surfaces, not those of a coordinate.
    of_surfaces: ClassVar[bool] = False

    def parameters(self) -> dict[str, float]:
        """Names and values of the parameters, in the order of the fields."""
        return {
            f.name: float(getattr(self, f.name))
            for f in dataclasses.fields(self)
            if f.type in ("float", float)
        }

    def table(self) -> tuple[float, ...]:
        """Numbers beyond the named parameters (data tables); reached as ``p[table_at + k]``."""
        return ()

    def functions(self) -> dict[str, Callable]:
        """The static functions of the part by name, those of base classes included."""
        return dict(functions_of(type(self)))  # type: ignore[arg-type]


@functools.lru_cache(maxsize=1024)
def functions_of(part: type) -> dict[str, Callable]:
    found: dict[str, Callable] = {}
    for cls in reversed(part.__mro__):
        for name, member in vars(cls).items():
            if isinstance(member, staticmethod) and not name.startswith("_"):
                found[name] = member.__func__
    return found


@functools.lru_cache(maxsize=4096)
def source_of(function: Callable, name: str) -> str:
    """Source text of ``function`` as a module-level function called ``name``.

    Parameters
    ----------
    function : callable
        A plain ``def`` of a file, its decorators left out.
    name : str
        Under which the text defines it.

    Raises
    ------
    TypeError
        If the source cannot be found or the function closes over variables.
    """
    if function.__closure__:
        raise TypeError(
            f"{function.__qualname__} uses variables of an enclosing function "
            f"({', '.join(function.__code__.co_freevars)}); pass them as parameters instead"
        )
    try:
        text = textwrap.dedent(inspect.getsource(function))
    except (OSError, TypeError) as error:
        raise TypeError(
            f"the source of {function.__qualname__} cannot be read ({error}); "
            "define it in a file, not in an interactive session"
        ) from error
    lines = text.splitlines()
    while lines and lines[0].lstrip().startswith("@"):
        lines.pop(0)
    head = lines[0]
    if not head.startswith("def "):
        raise TypeError(f"{function.__qualname__} must be a plain function, not a lambda")
    lines[0] = "def " + name + head[head.index("(") :]
    return "\n".join(lines) + "\n"


def arguments_of(function: Callable) -> list[str]:
    """Names of the arguments by which a part's function is wired.

    Parameters
    ----------
    function : callable
    """
    return list(_arguments_of(function))


@functools.lru_cache(maxsize=4096)
def _arguments_of(function: Callable) -> tuple[str, ...]:
    return tuple(inspect.signature(function).parameters)
