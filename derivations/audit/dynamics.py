"""Equations (12)-(23) and (30): inertia, equations of motion, friction law, link torques."""

from __future__ import annotations

import sympy as sp

from derivations import geometry as g
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
    equations_of_motion,
    free,
)
from derivations.audit.compare import same, same_matrix
from derivations.audit.verdict import Entry

CONVENTIONS = [(side, joint) for side in (-1, 1) for joint in ("joint CD", "joint AD")]
ASSUMED = "link B points away from link D's tip; r_D is measured from the joint of C and D"


def printed_inertia() -> dict[sp.Symbol, sp.Expr]:
    """Equations (12)-(14) as printed."""
    behind = s.R_D - s.L_B
    return {
        s.ALPHA: (s.M_A * s.R_A**2 + s.I_A + s.I_C + s.M_C * s.R_C**2 + s.M_D * s.L_A**2) / 2,
        s.BETA: (s.M_B * s.R_B**2 + s.I_B + s.I_D + s.M_C * s.L_B**2 + s.M_D * behind**2) / 2,
        s.GAMMA: s.M_C * s.R_C * s.L_B - s.M_D * s.L_A * behind,
    }


def _inertia_comes_out(symbol: sp.Symbol, conventions: list[tuple[int, str]]) -> bool:
    for side, joint in conventions:
        derived = lagrangian.lumped_inertia(lagrangian.from_links(side, joint).mass_matrix)
        if not same(derived[symbol], printed_inertia()[symbol]):
            return False
    return True


def _inertia_entry(number: str, what: str, symbol: sp.Symbol) -> Entry:
    literal_everywhere = _inertia_comes_out(symbol, CONVENTIONS)
    return Entry(
        number, what, "symbolically, Lagrange from Figure 2 in each of four conventions",
        lambda: literal_everywhere,
        condition="" if literal_everywhere else ASSUMED,
        conditional=None
        if literal_everywhere
        else lambda: _inertia_comes_out(symbol, CONVENTIONS[:1]),
    )  # fmt: skip


def _printed_15(speed_1: sp.Expr, speed_2: sp.Expr, acceleration: sp.Matrix) -> sp.Matrix:
    coupling = s.GAMMA * sp.sin(s.TH2 - s.TH1)
    mass = sp.Matrix([[2 * s.ALPHA, coupling], [coupling, 2 * s.BETA]])
    swing = s.GAMMA * sp.cos(s.TH2 - s.TH1)
    return mass * acceleration + sp.Matrix([swing * speed_2**2, -swing * speed_1**2])


def _is_15(*arguments: object) -> bool:
    printed = _printed_15(*arguments)
    lumped, links = lagrangian.from_lumped(), lagrangian.from_links()
    values = lagrangian.lumped_inertia(links.mass_matrix)
    derived = lumped.mass_matrix * s.QDD + lumped.velocity_terms
    from_links = links.mass_matrix * s.QDD + links.velocity_terms
    return same_matrix(printed, derived) and same_matrix(printed.subs(values), from_links)


def _lag_reaches_63_percent() -> bool:
    t, t_c = sp.symbols("t t_c", positive=True)
    step = 1 - sp.exp(-t / t_c)
    # 1/(t_c s + 1): t_c y' + y = u, y(0) = 0, for a unit step
    solves = same(t_c * step.diff(t) + step, 1) and step.subs(t, 0) == 0
    return bool(solves and same(step.subs(t, t_c), 1 - sp.exp(-1)))


def karnopp(force: float, velocity: float, band: float, limit: float, bars: bool) -> float:
    """Friction of (17) and (18); ``bars``: with |F_in| and the sign of F_in."""
    if abs(velocity) >= band:
        return limit * (1.0 if velocity > 0 else -1.0)
    if bars:
        return force if abs(force) <= limit else limit * (1.0 if force > 0 else -1.0)
    return force if force <= limit else limit


def _friction_is_bounded(loads: tuple[float, ...], bars: bool) -> bool:
    return all(abs(karnopp(load, 0.0, 1e-3, 1.0, bars)) <= 1.0 for load in loads)


def _friction_entry(number: str, what: str) -> Entry:
    return Entry(
        number, what, "evaluated at rest: friction may not exceed its breakaway value",
        lambda: _friction_is_bounded((-2.0, -0.5, 0.5, 2.0), bars=False),
        condition="load not negative; in general |in| <= B and B sign(in)",
        conditional=lambda: _friction_is_bounded((0.5, 2.0), bars=False)
        and _friction_is_bounded((-2.0, -0.5, 0.5, 2.0), bars=True),
        remark="the transcript keeps the bars of |V| on the same lines, so the missing ones are "
        "the thesis's; the band of zero velocity is numerical, not physical",
    )  # fmt: skip


def _link_torque(index: int, printed: sp.Expr, outside: sp.Symbol) -> bool:
    return same((g.CLUTCH_MAP.T * sp.Matrix(TAU))[index] + outside, printed)


def _printed_21(unknowns: sp.Matrix) -> sp.Matrix:
    tau1, tau2, tau3, tau4 = TAU
    links = sp.Matrix([tau1 + tau3 + tau4 + IN_A, tau2 - tau3 + tau4 + IN_B])
    return M * unknowns + V - links


def _printed_23() -> sp.Expr:
    ratio = M[0, 1] / M[1, 1]
    _, tau2, tau3, tau4 = TAU
    return ratio * tau2 - (ratio + 1) * tau3 + (ratio - 1) * tau4 + ratio * IN_B - IN_A + V[0]


def _inverts(sign: int) -> bool:
    """(30) with V added or subtracted solves (21) for the accelerations."""
    torques = g.CLUTCH_MAP.T * sp.Matrix(TAU) + sp.Matrix([IN_A, IN_B])
    solution = M.inv() * (torques + sign * V)
    return same_matrix(sp.Matrix(_printed_21(solution)), sp.zeros(2, 1))


def entries() -> list[Entry]:
    """Entries of equations (12)-(23) and (30)."""
    lagrange = "symbolically, Lagrange in alpha, beta, gamma and in the link data"
    solved = "symbolically: solved from (21) with the stuck clutch's acceleration zero"
    return [
        _inertia_entry("12", "alpha", s.ALPHA),
        _inertia_entry("13", "beta", s.BETA),
        _inertia_entry("14", "gamma", s.GAMMA),
        Entry(
            "15", "equations of motion", lagrange,
            lambda: _is_15(s.TH1, s.TH2, s.Q), "dots",
            lambda: _is_15(s.W1, s.W2, s.QDD),
        ),
        Entry("16", "first-order lag", "step response reaches 1 - 1/e at t_c",
              _lag_reaches_63_percent),
        _friction_entry("17", "Karnopp's friction force"),
        _friction_entry("18", "Karnopp's friction torque of a clutch"),
        Entry("19", "torque on link A", "first row of C' tau",
              lambda: _link_torque(0, TAU[0] + TAU[2] + TAU[3] + IN_A, IN_A)),
        Entry("20", "torque on link B", "second row of C' tau",
              lambda: _link_torque(1, TAU[1] - TAU[2] + TAU[3] + IN_B, IN_B)),
        Entry(
            "21", "equations of motion with clutch torques", "symbolically, (15) with (19), (20)",
            lambda: same_matrix(_printed_21(s.Q), sp.Matrix(equations_of_motion())), "dots",
            lambda: same_matrix(_printed_21(s.QDD), sp.Matrix(equations_of_motion())),
        ),
        Entry(
            "22", "condition for clutch 1 to remain stuck",
            "does it determine tau_1 in (21)?",
            lambda: case_torque((1,), [s.TH1]) is not None, "dots",
            lambda: case_torque((1,), [ACCELERATIONS[0]]) is not None,
        ),
        Entry(
            "23", "holding torque of clutch 1", solved,
            lambda: same(_printed_23(), free((1,))[TAU[0]]),
            condition="th1' = 0, as it is while clutch 1 sticks: then V2 = -gamma th1'^2 cos(...) "
            "is zero; in general add -(M12/M22) V2",
            conditional=lambda: same(
                _printed_23().subs(V[1], 0), free((1,))[TAU[0]].subs(V[1], 0)
            )
            and lagrangian.from_lumped().velocity_terms[1].subs(s.W1, 0) == 0,
        ),
        Entry(
            "30", "accelerations from link torques", "symbolically: put back into (21)",
            lambda: _inverts(+1), "dots, minus", lambda: _inverts(-1),
        ),
    ]  # fmt: skip
