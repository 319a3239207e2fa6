"""Parts of an error in words."""

from __future__ import annotations


def percent(part: float) -> str:
    """A part in per cent, without decimals; of less than one per cent the first two digits."""
    return f"{100 * part:.2g} %" if part < 0.01 else f"{100 * part:.0f} %"
