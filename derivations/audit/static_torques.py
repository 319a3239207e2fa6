"""Equations (54)-(77): holding torques of Cases 2 to 6 (Appendix A)."""

from __future__ import annotations

from functools import partial
from itertools import product

import sympy as sp

from derivations import lagrangian
from derivations import symbols as s
from derivations.audit.case_algebra import (
    ACCELERATIONS,
    IN_A,
    IN_B,
    TAU,
    M,
    V,
    case_torque,
    free,
    resting,
)
from derivations.audit.compare import same
from derivations.audit.verdict import Entry

T1, T2, T3, T4 = TAU
M11, M12, M21, M22 = M[0, 0], M[0, 1], M[1, 0], M[1, 1]
A1, A2 = ACCELERATIONS
SOLVED = "symbolically: solved from (21) under the case's constraint, M and V left general"


def _constraint(
    number: str,
    stuck: tuple[int, ...],
    literal: list[sp.Expr],
    restored: list[sp.Expr],
    what: str,
    remark: str = "",
) -> Entry:
    rest = len(stuck) > 1
    return Entry(
        number, what, "does it determine the holding torque in (21)?",
        lambda: case_torque(stuck, literal, rest) is not None, "dots",
        lambda: case_torque(stuck, restored, rest) is not None, remark=remark,
    )  # fmt: skip


def _speed_term(index: int, resting_speed: sp.Symbol) -> bool:
    """Whether V1 or V2 is zero while the link of the stuck clutch is at rest."""
    return lagrangian.from_lumped().velocity_terms[index].subs(resting_speed, 0) == 0


def _part(expression: sp.Expr, symbols: tuple[sp.Symbol, ...]) -> sp.Expr:
    """Terms of an expression, linear in torques and V, that carry one of these symbols."""
    return sum(sp.expand(expression).coeff(x) * x for x in symbols)


CLUTCH_TERMS = (T1, T2, T3, T4)
LOAD_TERMS = (IN_A, IN_B, V[0], V[1])


def _printed_direct(stuck: int, sign_of_tau3: int) -> tuple[sp.Expr, sp.Expr]:
    """(55), (56) for clutch 1 and (58), (59) for clutch 2: clutch terms and load terms."""
    if stuck == 1:
        ratio, other, own, foreign, v = M12 / M22, T2, IN_A, IN_B, V[0]
    else:
        ratio, other, own, foreign, v = M21 / M11, T1, IN_B, IN_A, V[1]
    clutches = ratio * other + sign_of_tau3 * (ratio + 1) * T3 + (ratio - 1) * T4
    return clutches, ratio * foreign - own + v


def _direct_clutches(stuck: int, sign_of_tau3: int = -1) -> bool:
    derived = _part(free((stuck,))[TAU[stuck - 1]], CLUTCH_TERMS)
    return same(_printed_direct(stuck, sign_of_tau3)[0], derived)


def _direct_loads(stuck: int, other_v_is_zero: bool) -> bool:
    derived = _part(free((stuck,))[TAU[stuck - 1]], LOAD_TERMS)
    if other_v_is_zero:
        derived = derived.subs(V[2 - stuck], 0)
    return same(_printed_direct(stuck, -1)[1], derived)


def _printed_61(brackets: bool) -> sp.Expr:
    factor = 1 / (M11 + M12 + M21 + M22)
    terms = (
        (M21 + M22) * (-T1 - IN_A + V[0]),
        (M11 + M12) * (T2 + IN_B - V[1]) + (M11 + M12 - M21 - M22) * T4,
    )
    return factor * sum(terms) if brackets else factor * terms[0] + terms[1]


def _printed_63(brackets: bool) -> sp.Expr:
    factor = 1 / (-M11 + M12 + M21 - M22)
    terms = (
        (M22 - M21) * (T1 + IN_A - V[0]),
        (M11 - M12) * (T2 + IN_B - V[1]) + (-M11 + M12 - M21 + M22) * T3,
    )
    return factor * sum(terms) if brackets else factor * terms[0] + terms[1]


def _holds(stuck: tuple[int, int], printed: dict[sp.Symbol, sp.Expr]) -> bool:
    derived = resting(stuck)
    return all(same(printed[t], derived[t]) for t in printed)


def _no_signs_help(stuck: tuple[int, int], printed: dict[sp.Symbol, sp.Expr]) -> bool:
    """Whether no choice of the signs of IN_A and IN_B repairs the printed torques."""
    derived = resting(stuck)
    for torque, expression in printed.items():
        repaired = any(
            same(
                expression.subs({IN_A: a * IN_A, IN_B: b * IN_B}, simultaneous=True),
                derived[torque],
            )
            for a, b in product((1, -1), repeat=2)
        )
        if not repaired:
            return True
    return False


PAIRS = {
    "67": ((1, 4), {T4: -IN_B, T1: -IN_A + IN_B}),
    "68": ((2, 3), {T3: -IN_A, T2: -IN_A - IN_B}),
    "69": ((2, 4), {T4: -IN_A, T2: IN_A - IN_B}),
    "72": ((1, 2), {T1: -IN_A}),
    "73": ((1, 2), {T2: -IN_B}),
    "76": ((3, 4), {T4: (-IN_A - IN_B) / 2}),
    "77": ((3, 4), {T3: (-IN_A + IN_B) / 2}),
}
PRINTED_66 = {T1: IN_B, T3: -IN_A - IN_B}


def _single_clutch_entries() -> list[Entry]:
    v_note = "th{0}' = 0 while clutch {0} sticks: then V{1} is zero; in general add -({2}) V{1}"
    return [
        _constraint("54", (1,), [s.TH1], [A1], "Case 2.1: clutch 1 stuck"),
        Entry("55", "Case 2.1: tau_1, terms of the clutches", SOLVED,
              lambda: _direct_clutches(1)),
        Entry(
            "56", "Case 2.1: tau_1, terms of load and V", SOLVED,
            lambda: _direct_loads(1, other_v_is_zero=False),
            condition=v_note.format(1, 2, "M12/M22"),
            conditional=lambda: _direct_loads(1, True) and _speed_term(1, s.W1),
        ),
        _constraint("57", (2,), [s.TH2], [A2], "Case 2.2: clutch 2 stuck"),
        Entry(
            "58", "Case 2.2: tau_2, terms of the clutches", SOLVED,
            lambda: _direct_clutches(2),
            corrected="tau_2 = (M21/M11) tau_1 + (M21/M11 + 1) tau_3 + (M21/M11 - 1) tau_4 + ...",
            correction=lambda: _direct_clutches(2, sign_of_tau3=1),
            remark="sign of the tau_3 term, carried over from (55); the transcript shows a minus "
            "and never adds one",
        ),
        Entry(
            "59", "Case 2.2: tau_2, terms of load and V", SOLVED,
            lambda: _direct_loads(2, other_v_is_zero=False),
            condition=v_note.format(2, 1, "M21/M11"),
            conditional=lambda: _direct_loads(2, True) and _speed_term(0, s.W2),
        ),
        _constraint("60", (3,), [s.TH1 - s.TH2], [A1 - A2], "Case 3.1: clutch 3 stuck"),
        Entry(
            "61", "Case 3.1: tau_3", SOLVED,
            lambda: same(_printed_61(brackets=False), free((3,))[T3]), "large brackets",
            lambda: same(_printed_61(brackets=True), free((3,))[T3]),
        ),
        _constraint("62", (4,), [s.TH1 + s.TH2], [A1 + A2], "Case 3.2: clutch 4 stuck",
                    "the text of A.5 says 'clutch three', twice"),
        Entry(
            "63", "Case 3.2: tau_4", SOLVED,
            lambda: same(_printed_63(brackets=False), free((4,))[T4]), "large brackets",
            lambda: same(_printed_63(brackets=True), free((4,))[T4]),
        ),
    ]  # fmt: skip


def entries() -> list[Entry]:
    """Entries of equations (54)-(77)."""
    found = _single_clutch_entries()
    rest = [A1, A2]
    position = [s.TH1, s.TH2]
    for number, stuck, link in (
        ("64", (1, 3), 1), ("65", (1, 3), 2), ("70", (1, 2), 1), ("71", (1, 2), 2),
        ("74", (3, 4), 1), ("75", (3, 4), 2),
    ):  # fmt: skip
        what = f"link {'AB'[link - 1]} at rest, clutches {stuck[0]} and {stuck[1]} stuck"
        found.append(_constraint(number, stuck, position, rest, what))
    found.append(
        Entry(
            "66", "clutches 1, 3 stuck: tau_1 and tau_3", SOLVED,
            lambda: _holds((1, 3), PRINTED_66),
            corrected="tau_1 = -tau_inA - tau_inB, tau_3 = tau_inB",
            correction=lambda: _holds((1, 3), {T1: PRINTED_66[T3], T3: PRINTED_66[T1]})
            and _no_signs_help((1, 3), PRINTED_66),
            remark="the two names are exchanged; no lost minus signs would repair it",
        )
    )  # fmt: skip
    for number, (stuck, printed) in PAIRS.items():
        names = " and ".join(f"tau_{TAU.index(t) + 1}" for t in printed)
        found.append(
            Entry(number, f"clutches {stuck[0]}, {stuck[1]} stuck: {names}", SOLVED,
                  partial(_holds, stuck, printed))
        )  # fmt: skip
    return sorted(found, key=lambda entry: int(entry.number))
