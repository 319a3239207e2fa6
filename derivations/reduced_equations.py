"""The generated functions of ``pter_reduced``: six motions, holding torques, stick margins."""

from __future__ import annotations

import sympy as sp

from derivations import lagrangian
from derivations.bindings import bindings
from derivations.codegen import Function
from derivations.geometry import CLUTCH_MAP
from derivations.reduced import acceleration, holding_torques, stick_margins
from derivations.stuck_sets import StuckSet, all_stuck_sets, mask_of
from derivations.symbols import BRK, G

HEADER = '''"""PTER's reduced equations for each of the 16 sets of stuck clutches: 6 motions.

A set is a bit mask: bit i is clutch i + 1. g [N m] (2,) is the net generalized force of the
operator and of the slipping clutches, without velocity terms; the equations are
M qdd + V = g + C_S' tau_S with C_S qdd = 0. Layout of q, qd, p: see ``pter_equations``.

flow_<motion>    acceleration, qdd[2] [rad/s^2]
hold_<mask>      holding torques where they are unique, tau[4] [N m], zero for the other clutches
margin_<mask>    least stick margin [N m] for the symmetric breakaway torques brk[4] [N m]: the set
                 holds while it is >= 0. Facet normals are scaled to max |C_i y| = 1 over the set,
                 so that it is min(brk_i - |tau_i|) where the holding torques are unique.
"""
'''

#: thesis case of every stuck set (its Tables 1 and 2), by 1-based clutch numbers
THESIS_CASES = {
    (): "1", (1,): "2.1", (2,): "2.2", (3,): "3.1", (4,): "3.2",
    (1, 3): "4.1", (1, 4): "4.2", (2, 3): "4.3", (2, 4): "4.4", (1, 2): "5", (3, 4): "6",
    (1, 2, 3): "7.1", (1, 2, 4): "7.2", (1, 3, 4): "7.3", (2, 3, 4): "7.4", (1, 2, 3, 4): "7.5",
}  # fmt: skip


def _names(clutches: tuple[int, ...]) -> str:
    numbers = [str(i + 1) for i in clutches]
    if not numbers:
        return "no clutch stuck"
    if len(numbers) == 1:
        return f"clutch {numbers[0]} stuck"
    return f"clutches {', '.join(numbers[:-1])} and {numbers[-1]} stuck"


def _case(stuck: StuckSet) -> str:
    return THESIS_CASES[tuple(i + 1 for i in stuck.clutches)]


def motions(sets: tuple[StuckSet, ...]) -> dict[str, StuckSet]:
    """One stuck set for each distinct motion, the smallest mask first."""
    found: dict[str, StuckSet] = {}
    for stuck in sets:
        found.setdefault(stuck.motion, stuck)
    return found


def flow_functions() -> list[Function]:
    """One ``flow_<motion>`` for each distinct motion."""
    motion = lagrangian.from_lumped()
    arguments = ("q", "qd", "g", "p", "qdd")
    return [
        Function(
            f"flow_{name}",
            arguments,
            f"Acceleration with {_names(stuck.closure)}.",
            bindings(arguments),
            tuple(acceleration(motion, stuck, G)),
            "qdd",
        )
        for name, stuck in motions(all_stuck_sets(CLUTCH_MAP)).items()
    ]


def hold_functions() -> list[Function]:
    """One ``hold_<mask>`` for each independent stuck set."""
    motion = lagrangian.from_lumped()
    arguments = ("q", "qd", "g", "p", "tau")
    functions = []
    for stuck in all_stuck_sets(CLUTCH_MAP):
        if not stuck.independent:
            continue
        torques = [sp.Integer(0)] * CLUTCH_MAP.rows
        if stuck.clutches:
            solved = holding_torques(motion, stuck, G)
            for clutch, torque in zip(stuck.clutches, solved, strict=True):
                torques[clutch] = torque
        doc = f"Holding torques with {_names(stuck.clutches)} (Case {_case(stuck)})."
        functions.append(
            Function(
                f"hold_{stuck.mask}", arguments, doc, bindings(arguments), tuple(torques), "tau"
            )
        )
    return functions


def margin_functions() -> list[Function]:
    """One ``margin_<mask>`` for each stuck set; infinite where nothing is stuck."""
    motion = lagrangian.from_lumped()
    arguments = ("q", "qd", "g", "brk", "p")
    functions = []
    for stuck in all_stuck_sets(CLUTCH_MAP):
        margins = stick_margins(motion, stuck, G, BRK)
        least = sp.Min(*margins, evaluate=False) if len(margins) > 1 else sp.Min(*margins)
        doc = f"Least stick margin with {_names(stuck.clutches)} (Case {_case(stuck)})."
        functions.append(
            Function(f"margin_{stuck.mask}", arguments, doc, bindings(arguments), (least,))
        )
    return functions


def tables_text() -> str:
    """Dictionaries at the end of the module, for tests and logs."""
    sets = all_stuck_sets(CLUTCH_MAP)
    rows: dict[str, dict] = {
        "MOTION_OF_MASK": {s.mask: f'"{s.motion}"' for s in sets},
        "THESIS_CASE_OF_MASK": {s.mask: f'"{_case(s)}"' for s in sets},
        "CLOSURE_OF_MASK": {s.mask: str(mask_of(s.closure)) for s in sets},
        "FLOW_OF_MOTION": {f'"{m}"': f"flow_{m}" for m in motions(sets)},
        "HOLD_OF_MASK": {s.mask: f"hold_{s.mask}" for s in sets if s.independent},
        "MARGIN_OF_MASK": {s.mask: f"margin_{s.mask}" for s in sets},
    }
    comments = {
        "MOTION_OF_MASK": "which of the six motions a stuck set leaves",
        "THESIS_CASE_OF_MASK": "case number of the thesis (its Tables 1 and 2)",
        "CLOSURE_OF_MASK": "mask of all clutches whose slip velocity is then zero",
        "FLOW_OF_MOTION": "",
        "HOLD_OF_MASK": "stuck sets with unique holding torques",
        "MARGIN_OF_MASK": "",
    }
    parts = []
    for name, table in rows.items():
        comment = f"#: {comments[name]}\n" if comments[name] else ""
        items = "".join(f"    {key}: {value},\n" for key, value in table.items())
        parts.append(f"{comment}{name} = {{\n{items}}}\n")
    return "\n".join(parts)
