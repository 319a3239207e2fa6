"""What effects do whose sizes have the unusual sign: their names do not say it."""

from __future__ import annotations

from collections.abc import Mapping

from ..recordings.row_step import row_step
from ..result import Diagnosis

#: Effect -> its size, and what it does where that is below 0.
OTHER_WAY = {
    "degressive-speed": ("rise", "friction falls with speed, ever less"),
    "logarithmic-speed": ("rise", "friction falls with speed"),
    "stribeck": ("rise", "friction rises with speed, to a level"),
    "stribeck-2": ("rise", "friction rises with speed, to a level"),
    "thermal-fade": ("fade", "friction rises as it warms"),
    "sensor delay": ("delay", "the sensor is early, or all others are late"),
    "force-delay": ("delay", "the sensor is early, or what it measures acts late"),
}
#: What acts so many rows later than it is read may hold its value between them, or be set anew.
OF_A_ROW = 0.2, 0.8


def other_way(found: Diagnosis, name: str, values: Mapping[str, float]) -> str:
    """Words on what an effect does where its sizes have the unusual sign; "" if none has.

    Parameters
    ----------
    found : Diagnosis
    name : str
        Of the effect; one "by clutch" or "by joint" has a size at each.
    values : mapping of str to float
        As they were fitted.
    """
    plain, _, place = name.partition(" by ")
    size, says = OTHER_WAY.get(plain, ("", ""))
    own, end = f"{name}.", f".{size}"
    sizes = {
        n.removeprefix(own).removesuffix(size).rstrip("."): value for n, value in values.items()
        if size and n.startswith(own) and n.endswith(end)
    }  # fmt: skip
    below = [label for label, value in sizes.items() if value < 0.0]
    if not below:
        return ""
    if len(below) < len(sizes):
        return f" (at {place} {' and '.join(below)} {says})"
    if name == "force-delay" and found.fitted:
        rows = -sizes[""] / row_step(found.fitted[0].time)
        if OF_A_ROW[0] <= rows <= OF_A_ROW[1]:
            says += f", by {rows:.2g} rows: as a drive that holds between rows does (`held`)"
    return f" (here {says})"
