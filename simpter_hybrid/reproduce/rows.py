"""One line of a comparison with the thesis: what it prints, what comes out here, the verdict."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass
from typing import Any

from ..scenario import Scenario
from ..trajectory import Trajectory

#: The three verdicts.
HOLDS, FAILS, UNCOMPARABLE = "holds", "does not hold", "cannot be compared"

Engine = Callable[[Scenario], Trajectory]


@dataclass(frozen=True)
class Row:
    """One comparison.

    Parameters
    ----------
    item : str
        Number in the checklist of the thesis's contents (A1 ... S73), several by spaces.
    claim : str
        What is compared, in a sentence or a noun.
    printed : str
        What the thesis prints.
    ours : str
        What comes out here.
    verdict : str
        ``holds``, ``does not hold`` or ``cannot be compared``.
    why : str
        For the last two: what is missing or different.
    share : float, optional
        Share of the plausible inputs for which the claim holds; None where none were drawn.
    numbers : mapping
        The numbers behind ``ours``, for tests and files.
    """

    item: str
    claim: str
    printed: str
    ours: str
    verdict: str
    why: str = ""
    share: float | None = None
    numbers: dict[str, Any] | None = None

    def __post_init__(self) -> None:
        if self.verdict not in (HOLDS, FAILS, UNCOMPARABLE):
            raise ValueError(
                f"verdict {self.verdict!r} of {self.item} is unknown; it has to be {HOLDS!r}, "
                f"{FAILS!r} or {UNCOMPARABLE!r}"
            )

    def as_dict(self) -> dict[str, Any]:
        """Ready for JSON."""
        return asdict(self)


def judged(condition: bool) -> str:
    """``holds`` or ``does not hold``."""
    return HOLDS if condition else FAILS


def claim(
    item: str,
    words: str,
    printed: str,
    ours: str,
    condition: bool,
    *,
    why: str = "",
    share: float | None = None,
    **numbers: Any,
) -> Row:
    """A row whose verdict is computed from a condition."""
    verdict = judged(bool(condition))
    return Row(item, words, printed, ours, verdict, why, share, dict(numbers) or None)


def number(
    item: str,
    words: str,
    printed: float,
    ours: float,
    unit: str,
    *,
    relative: float,
    why: str = "",
    digits: int = 4,
) -> Row:
    """A row that compares two numbers that should agree to within ``relative``."""
    text = f"{ours:.{digits}g} {unit}".strip()
    row = claim(
        item,
        words,
        f"{printed:g} {unit}".strip(),
        text,
        abs(ours - printed) <= relative * abs(printed),
        why=why,
        printed_value=printed,
        ours_value=ours,
    )
    return row


def uncomparable(
    item: str,
    words: str,
    printed: str,
    ours: str,
    why: str,
    *,
    share: float | None = None,
    **numbers: Any,
) -> Row:
    """A row that states why there is no verdict."""
    return Row(item, words, printed, ours, UNCOMPARABLE, why, share, dict(numbers) or None)


def plain(value):
    """NumPy scalars and arrays as JSON has them."""
    return value.tolist() if hasattr(value, "tolist") else str(value)
