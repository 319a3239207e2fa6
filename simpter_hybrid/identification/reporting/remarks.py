"""Remarks of a report: one that fails costs neither the others nor the report."""

from __future__ import annotations

from collections.abc import Callable, Mapping


def made(
    remarks: Mapping[str, Callable[[], str]], failed: dict[str, Exception] | None
) -> dict[str, str]:  # fmt: skip
    """Texts of remarks by their names; "" of one that failed.

    Parameters
    ----------
    remarks : mapping of str to callable
    failed : dict of str to Exception or None
        Takes up what failed, for whoever keeps the report to raise; None: raised at once.
    """
    texts = {}
    for name, tell in remarks.items():
        try:
            texts[name] = tell()
        except Exception as error:
            if failed is None:
                raise
            failed[name], texts[name] = error, ""
    return texts


def failed_sentence(failed: Mapping[str, Exception]) -> str:
    """Sentence on remarks that failed; "" if none did."""
    if not failed:
        return ""
    told = "; ".join(f"{name}: {type(e).__name__}, {e}" for name, e in failed.items())
    return (
        f"Not all that is to be said could be worked out ({told}). That is an error of this "
        "program, which should be reported; all else is as found."
    )
