"""Problems of an input, collected so that a person can mend all of them at once."""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

#: Where a value stands, e.g. ``("effects", 1, "name")``.
KeyPath = tuple[str | int, ...]

_LONGEST = 80  # characters of a value in a message
_BARE_KEY = re.compile(r"[A-Za-z0-9_-]+")


class _Missing:
    """The value of a key that is not there."""


MISSING = _Missing()


class Problem(NamedTuple):
    """One thing wrong: where (file:line), at which key, what, the value, what would be right."""

    where: str
    path: str
    what: str
    value: str
    right: str

    def __str__(self) -> str:
        named = not self.path or self.where.endswith(f" {self.path}")  # by "--set load.angle"
        place = self.where if named else f"{self.where}: {self.path}"
        return f"{place}: {self.what}, got {self.value}; expected {self.right}"


class InvalidInput(ValueError):
    """All that is wrong with an input; ``str()`` has one line for each of `problems`."""

    def __init__(self, problems: Iterable[Problem]) -> None:
        self.problems = tuple(problems)
        super().__init__("\n".join(map(str, self.problems)))

    def __reduce__(self) -> tuple[type, tuple]:
        return type(self), (self.problems,)  # workers hand it over whole


class CompiledUnavailable(ImportError):
    """Machine code that cannot be had: no compiler, or a model that it does not take.

    Parameters
    ----------
    what, got, right : str
        What is wrong, what there is, and what would be right.
    otherwise : str
        What needs no machine code, where there is a choice.
    """

    def __init__(
        self, what: str, got: str, right: str, otherwise: str = "use engine 'reference'"
    ) -> None:
        self.what, self.got, self.right, self.otherwise = what, got, right, otherwise
        super().__init__(f"{what}, got {got}; expected {right}, or {otherwise}")

    def __reduce__(self) -> tuple[type, tuple]:
        return type(self), (self.what, self.got, self.right, self.otherwise)

    def invalid(self, where: str, otherwise: str = "") -> InvalidInput:
        """This error as an InvalidInput about what was asked for at ``where``.

        Parameters
        ----------
        where : str
            What asked for machine code, e.g. ``engine``.
        otherwise : str
            What to ask for instead, if there is anything.
        """
        right = f"{self.right}; or {otherwise}" if otherwise else self.right
        return InvalidInput([Problem(where, "", self.what, self.got, right)])


class Problems:
    """Collects what is wrong with one input.

    Parameters
    ----------
    source : str
        Name of the file, as the user wrote it, or of whatever else the values come from.
    places : mapping, optional
        Line of each path, or text of the override that set it (``--set load.angle``).
    """

    def __init__(self, source: str, places: Mapping[KeyPath, int | str] | None = None) -> None:
        self.source = source
        self.places = dict(places or {})
        self._found: list[tuple[float, Problem]] = []

    def __len__(self) -> int:
        return len(self._found)

    def add(
        self, path: KeyPath, what: str, value: Any, right: str, where: str | None = None
    ) -> None:
        """Record a problem at `path`: what is wrong, the value met, what would be right.

        `where` takes the place of the line known for the path; such problems come last.

        Parameters
        ----------
        path : tuple of str or int
            Of the key, e.g. ``("effects", 1, "name")``; () for the input as a whole.
        what, right : str
            What is wrong, and what would be right.
        value : object
            Shown as ``show`` does; `MISSING` where there is none.
        where : str, optional
            E.g. ``--vary``.
        """
        order, known = self._locate(path) if where is None else (math.inf, where)
        problem = Problem(known, path_text(path), what, show(value), right)
        self._found.append((order, problem))

    def raise_if_any(self) -> None:
        """End the collecting: raise everything recorded, in the order of the lines, or do nothing.

        Raises
        ------
        InvalidInput
            With everything recorded, if anything was.
        """
        if self._found:
            raise InvalidInput(problem for _, problem in sorted(self._found, key=lambda f: f[0]))

    def place(self, path: KeyPath) -> str:
        """File and line of a key or, where it is missing, of the nearest table around it."""
        return self._locate(path)[1]

    def _locate(self, path: KeyPath) -> tuple[float, str]:
        """Where the key stands or, where it is missing, the nearest table around it."""
        while path and path not in self.places:
            path = path[:-1]
        place = self.places.get(path, 1)
        if isinstance(place, str):
            return math.inf, place
        return place, f"{self.source}:{place}" if self.places else self.source


def together(*checks: Callable[[], Any]) -> list[Any]:
    """What all `checks` give, in their order; each runs even if another fails.

    Parameters
    ----------
    *checks : callable
        Called without arguments.

    Raises
    ------
    InvalidInput
        With the problems of all checks that raise it.
    """
    found: list[Problem] = []
    given = []
    for check in checks:
        try:
            given.append(check())
        except InvalidInput as wrong:
            found += wrong.problems
    if found:
        raise InvalidInput(found)
    return given


def path_text(path: KeyPath) -> str:
    """``("effects", 1, "name")`` as ``effects.1.name``, the form that ``--set`` takes.

    Parameters
    ----------
    path : tuple of str or int
        Keys, and numbers in arrays from 0.
    """
    keys = (str(key) for key in path)
    return ".".join(key if _BARE_KEY.fullmatch(key) else show(key) for key in keys)


def show(value: Any) -> str:
    """A value as it would stand in a TOML file, cut to one short line.

    Parameters
    ----------
    value : object
        Anything; `MISSING` is shown as ``nothing``.
    """
    if value is MISSING:
        return "nothing"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, Mapping):
        return "a table"
    if isinstance(value, list | tuple):
        return f"an array of {len(value)}"
    if isinstance(value, int) and abs(value) > 10**_LONGEST:
        return f"an integer of more than {_LONGEST} digits"
    text = str(value)[: _LONGEST + 1]
    text = "".join(c if c.isprintable() else ascii(c)[1:-1] for c in text)
    text = text if len(text) <= _LONGEST else text[: _LONGEST - 3] + "..."
    return f'"{text}"' if isinstance(value, str) else text
