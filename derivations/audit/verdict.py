"""An audited item and the verdict that follows from its checks.

The source is a transcript that has lost marks. A reading of it may be

* ``literal``: the transcript as it stands (layout such as raised exponents, fraction bars and
  matrix brackets is flattened there throughout; that alone is read back, not counted as a loss);
* ``restored``: with marks put back of a kind that the transcript demonstrably loses (LOSSES);
* ``conditional``: the restored reading under a condition that the thesis does not state there;
* ``correction``: another formula, the one that the derivation gives.

The first of these that holds gives the verdict, so a verdict cannot be typed in.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

AGREES = "agrees"
DAMAGED = "transcript damaged"
CONDITIONAL = "agrees under a stated condition"
MISPRINTED = "misprinted"
CONTRADICTED = "contradicted"
OPEN = "UNEXPLAINED"

#: Marks the transcript loses, each with a place where the loss is certain from the words beside it.
#: It never adds a mark or turns one into another, and it keeps absolute-value bars (17, 48, 53).
LOSSES = {
    "dots": "(22): 'setting its relative angular acceleration to zero' beside theta = 0",
    "root": "(44): the second of two equal distances has its root, the first has not",
    "minus": "(30): the two vectors stand side by side without an operator",
    "large brackets": "(61): a product sign ends the line, two more lines follow",
    "tilde": "(45): the same symbol on both sides",
    "integral signs": "(32): an integrand stands without its integral",
    "exponent": "count of modes: '24 possible ... with four surfaces' for 2 to the 4th",
}

Check = Callable[[], bool]


@dataclass(frozen=True)
class Entry:
    """One audited item; see the module's text for the four readings.

    Attributes
    ----------
    number
        Equation number, or a label of the count, table or statement.
    what
        What it says.
    how
        How it was checked.
    lost
        Kinds of LOSSES met here, comma separated.
    condition, corrected
        Text of the condition under which it agrees, or of the correct form.
    fault
        Verdict if only the correction holds.
    remark
        What else a reader should know.
    """

    number: str
    what: str
    how: str
    literal: Check
    lost: str = ""
    restored: Check | None = None
    condition: str = ""
    conditional: Check | None = None
    corrected: str = ""
    correction: Check | None = None
    fault: str = MISPRINTED
    remark: str = ""

    def __post_init__(self) -> None:
        kinds = {kind.strip() for kind in self.lost.split(",") if kind.strip()}
        if kinds - set(LOSSES):
            raise ValueError(f"{self.number}: {kinds - set(LOSSES)} is no loss of the transcript")
        if self.restored is not None and not kinds:
            raise ValueError(f"{self.number}: a restored reading needs a mark that was lost")
        if (self.conditional is None) != (not self.condition):
            raise ValueError(f"{self.number}: a condition and its check belong together")
        if (self.correction is None) != (not self.corrected):
            raise ValueError(f"{self.number}: a correction and its check belong together")


@dataclass(frozen=True)
class Assessment:
    """Verdict of an entry and the outcome of each of its checks, in the order tried."""

    verdict: str
    outcomes: tuple[tuple[str, bool], ...]


@cache
def assess(entry: Entry) -> Assessment:
    """Run the checks of an entry: all of them, so that a needless one shows up."""
    readings = (
        ("literal", entry.literal, AGREES),
        ("restored", entry.restored, DAMAGED),
        ("conditional", entry.conditional, CONDITIONAL),
        ("correction", entry.correction, entry.fault),
    )
    outcomes = tuple((name, bool(check())) for name, check, _ in readings if check is not None)
    held = dict(outcomes)
    # a statement that fails against figure, table or derivation needs no known correction
    failed = CONTRADICTED if entry.fault == CONTRADICTED else OPEN
    verdict = next((v for name, _, v in readings if held.get(name)), failed)
    return Assessment(verdict, outcomes)
