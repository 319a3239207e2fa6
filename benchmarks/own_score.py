"""Whether a verdict on a recording is right, given what the recording hides."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from own_testbed_effects import KINDS

from simpter_hybrid.identification.tracing.verdict import LACKING

Row = Mapping[str, Any]
NAMED = ("effect", "form incomplete")
CONTESTED = "cannot be told apart"


def short(row: Mapping[str, Any]) -> str:
    """What a verdict says, in one word for the confusion matrix."""
    if row["verdict"] in NAMED:
        return "+".join(row["effects"])
    if row["verdict"] == CONTESTED:
        return CONTESTED
    return row["verdict"]


def score(row: Mapping[str, Any]) -> str:
    """``right``, ``set with it``, ``part``, ``spurious``, ``misnamed``, ``unknown``, ``missed``.

    Of what hides nothing or what is in nobody's list, ``right`` is to name nothing; an unknown
    is right only with a coordinate that belongs to it, else it is ``unknown``.  Without the right
    effects in the library an unknown is right that says on what it depends.
    """
    if row["verdict"].startswith("refused") or row["verdict"] == "error":
        return row["verdict"]
    hidden = [name for name in row["hides"] if KINDS[name].names and row.get("group") != "without"]
    if not hidden:
        return _of_nothing(row)
    if row["verdict"] == "nothing missing":
        return "missed"
    if row["verdict"] in LACKING:
        return "unknown"
    found, allowed = set(row["effects"]), [set(KINDS[name].names) for name in hidden]
    hit = [bool(found & names) for names in allowed]
    wrong = found - set().union(*allowed)
    if row["verdict"] == CONTESTED:
        whole = found | set(row["cannot_exclude"])
        return "set with it" if all(whole & names for names in allowed) else "set without it"
    if not any(hit):
        return "misnamed"
    if wrong:
        return "spurious"
    return "right" if all(hit) else "part"


def told_unseen(row: Row) -> bool:
    """Whether what was missed stands among what the diagnosis says these runs cannot show."""
    names = [set(KINDS[name].names) for name in row["hides"]]
    return row["score"] == "missed" and all(n & set(row.get("blind_to", ())) for n in names)


def _of_nothing(row: Mapping[str, Any]) -> str:
    if row["verdict"] in (*NAMED, CONTESTED):
        return "named" if row["verdict"] in NAMED else "set named"
    if not row["hides"]:
        return "right" if row["verdict"] == "nothing missing" else "unknown"
    if row["verdict"] == "nothing missing":
        return "missed"
    if row.get("group") == "without":
        return "right" if row["depends_on"] else "unknown"
    (name,) = row["hides"]
    said = {c.partition(":")[2] for c in row["depends_on"]}
    return "right" if said & set(KINDS[name].depends) else "unknown"


def size_error(row: Mapping[str, Any]) -> float | None:
    """Relative error of the fitted size where the truth can be stated in the library's terms."""
    for name, strength in row["hides"].items():
        measure = KINDS[name].measure
        if measure is None or measure[0] not in row["values"]:
            continue
        truth = strength * measure[1]
        return abs(abs(row["values"][measure[0]]) / truth - 1.0)
    return None


def size(row: Row) -> float | None:
    """Relative error of the size, where it can be told."""
    return size_error(row) if "values" in row else row.get("size_error")


def ratio(row: Row) -> float | None:
    """Error after over the floor."""
    return row["after"] / row["floor"] if "after" in row else None
