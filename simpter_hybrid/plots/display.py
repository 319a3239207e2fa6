"""The units that pictures and tables are shown in; the numbers behind them are SI."""

from __future__ import annotations

from dataclasses import dataclass

from ..known_units import INCH, LBF


@dataclass(frozen=True)
class Display:
    """For every SI unit the unit shown and the factor to it."""

    name: str
    shown: dict[str, tuple[str, float]]

    def unit(self, si: str) -> str:
        """The unit shown for an SI unit (written as in ``units.DIMENSIONS``)."""
        return self.shown.get(si, (si, 1.0))[0]

    def factor(self, si: str) -> float:
        """What a value in the SI unit is multiplied by."""
        return self.shown.get(si, (si, 1.0))[1]

    def axis(self, words: str, si: str) -> str:
        """An axis label with its unit."""
        return f"{words} [{self.unit(si)}]"


_ANGULAR = {"rad/s^2": ("rad/s²", 1.0), "rad/s^3": ("rad/s³", 1.0)}
SI = Display("SI", {"m/s^2": ("m/s²", 1.0), "m/s^3": ("m/s³", 1.0), **_ANGULAR})
#: The thesis's units.
THESIS = Display(
    "thesis",
    {
        "m": ("in", 1.0 / INCH),
        "m/s": ("in/s", 1.0 / INCH),
        "m/s^2": ("in/s²", 1.0 / INCH),
        "m/s^3": ("in/s³", 1.0 / INCH),
        "N": ("lbf", 1.0 / LBF),
        "N m": ("lbf in", 1.0 / (LBF * INCH)),
        "J": ("lbf in", 1.0 / (LBF * INCH)),
        **_ANGULAR,
    },
)
DISPLAYS = {"SI": SI, "thesis": THESIS}
