"""What a page says where a lack depends on something that the table of residuals does not show."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from ..tracing.locating import FAINT, LEAST_DEPENDENCE
from .dependence_text import depends_on


def by_curves_text(data: Mapping[str, Any]) -> str:
    """Sentence on a dependence that fitted curves show alone; "" if the table shows all of it.

    The table asks the residual force, which noisy positions smear; a curve that is fitted in the
    simulation is held to whole courses (`unexplained.asked_by_curves`).

    Parameters
    ----------
    data : mapping
        Of `diagnosis_data`.
    """
    curve = data["empirical"]
    shown = _shown(data["rounds"])
    alone = [c for c in data["depends_on"] if c not in shown]
    if not curve or curve["coordinate"] not in alone:
        return ""
    straight = data.get("straight", False)
    others = "; those over the others do nearly as well" if len(alone) > 1 else ""
    on, best = depends_on(alone, straight), depends_on([curve["coordinate"]], straight)
    return (
        f"That what is left depends on {on} this table does not show: it is told by curves that "
        f"were fitted in the simulation itself, of which the best, over {best}, lowers the error "
        f"of the runs that select by {100 * curve['gain']:.0f} %{others}."
    )


def _shown(rounds: Any) -> set[str]:
    """Every ``balance:coordinate`` along which a table's residuals depend, by its part and p."""
    tables = [rounds[0]["before"], rounds[-1]["before"], rounds[-1]["after"]] if rounds else []
    return {
        f"{balance}:{d['coordinate']}"
        for told in tables
        for balance, found in told.items()
        for d in found
        if d["gain"] >= LEAST_DEPENDENCE and d["p_value"] <= FAINT
    }
