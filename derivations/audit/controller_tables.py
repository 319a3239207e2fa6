"""Tables 5 and 6, the controllers side by side, and what the thesis reads off them."""

from __future__ import annotations

from derivations.audit.verdict import CONTRADICTED, Entry

TABLE_5 = {
    "baseline": (0.360, 1.078, 456, 40118, 32.205, 31.53, 139.8),
    "feedback": (0.132, 0.299, 317, 3501, 31.154, 17.58, 79.69),
}
TABLE_6 = {"baseline": (0.360, 1.078, 456, 40118, 32.205, 31.53, 139.8),
           "feedback": (0.132, 0.299, 317, 3501, 31.154, 17.58, 79.69),
           "velocity": (0.067, 0.161, 439, 49774, 31.034, 15.77, 42.18)}  # fmt: skip


def _column(index: int) -> list[float]:
    return [TABLE_6[name][index] for name in ("velocity", "feedback", "baseline")]


def _jerk_rises_against(name: str) -> bool:
    return all(TABLE_6["velocity"][k] > TABLE_6[name][k] for k in (2, 3))


def entries() -> list[Entry]:
    """Entries of the controllers' tables."""
    return [
        Entry("Table 5", "baseline and feedback rows agree with Table 6", "row by row",
              lambda: all(TABLE_5[k] == TABLE_6[k] for k in TABLE_5), fault=CONTRADICTED),
        Entry("5.5.2", "velocity controller: best error and accelerations, less smooth than "
              "feedback", "columns of Table 6",
              lambda: all(_column(k) == sorted(_column(k)) for k in (0, 1, 4, 5, 6))
              and _jerk_rises_against("feedback"), fault=CONTRADICTED),
        Entry(
            "6.2.2.2", "jerk increased over the existing impedance controller", "Table 6",
            lambda: _jerk_rises_against("baseline"),
            condition="over the impedance controller with torque feedback; against the baseline "
            "the average falls from 456 to 439",
            conditional=lambda: _jerk_rises_against("feedback"), fault=CONTRADICTED,
        ),
    ]  # fmt: skip
