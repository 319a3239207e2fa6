"""Equations (1)-(11): positions and Jacobians."""

from __future__ import annotations

import math

import sympy as sp

from derivations import geometry as g
from derivations import kinematics
from derivations.audit import path
from derivations.audit.compare import random_points, same, same_angle, same_matrix
from derivations.audit.verdict import Entry
from derivations.symbols import L_A, L_B, L_D, QD, TH1, TH2, W1, W2, Q

LENGTHS = (0.92, 0.61)
POSES = list(random_points(300, 1, 2, math.pi))


def _tip_around_the_linkage() -> sp.Matrix:
    """Tip by the other way round: along B, C and D instead of along A and D."""
    return g.B_SIDE * L_B * g.U2 + L_A * g.U1 + (L_B + L_D) * g.U2


def _printed_tip() -> sp.Matrix:
    return sp.Matrix([L_A * sp.cos(TH1) - L_D * sp.sin(TH2), L_A * sp.sin(TH1) + L_D * sp.cos(TH2)])


def _tip(index: int) -> bool:
    return all(same(_printed_tip()[index], t[index]) for t in (g.TIP, _tip_around_the_linkage()))


def _position(th1: float, th2: float) -> tuple[float, float]:
    l_a, l_d = LENGTHS
    return (
        l_a * math.cos(th1) - l_d * math.sin(th2),
        l_a * math.sin(th1) + l_d * math.cos(th2),
    )


def _q1(x: float, y: float) -> float:
    l_a, l_d = LENGTHS
    cosine = (x * x + y * y - l_a**2 - l_d**2) / (2 * l_a * l_d)
    return math.acos(max(-1.0, min(1.0, cosine)))


def _q2(x: float, y: float, q1: float) -> float:
    l_a, l_d = LENGTHS
    sine = ((l_a + l_d * math.cos(q1)) * y - l_d * math.sin(q1) * x) / (x * x + y * y)
    return math.asin(max(-1.0, min(1.0, sine)))


def _elbow(th1: float, th2: float) -> float:
    """Angle from link A to link D: the q1 that (3) and (6) speak of."""
    return th2 + math.pi / 2 - th1


def _q1_returns(all_poses: bool) -> bool:
    chosen = [p for p in POSES if all_poses or math.cos(p[0] - p[1]) > 1e-3]
    return all(same_angle(_q1(*_position(*p)), _elbow(*p), 1e-6) for p in chosen)


def _q2_returns(all_poses: bool) -> bool:
    chosen = [p for p in POSES if all_poses or abs(p[0]) < math.pi / 2 - 1e-3]
    return all(same_angle(_q2(*_position(*p), _elbow(*p)), p[0], 1e-6) for p in chosen)


def _largest_angle_on_the_path() -> float:
    """Largest th1 [deg] on y = 24 in with the inferred lengths."""
    return max(math.degrees(path.pose(x, *path.LENGTHS)[0]) for x in path.STATIONS)


def _theta_1_satisfies_4() -> bool:
    x, y = g.TIP
    elbow = TH2 + sp.pi / 2 - TH1
    left = sp.sin(TH1) * (x**2 + y**2)
    return same(left, (L_A + L_D * sp.cos(elbow)) * y - L_D * sp.sin(elbow) * x)


def _theta_2_is_q1_plus_q2(quarter_turns: int) -> bool:
    """Whether th2 = q1 + q2 + k pi/2 puts the tip of (1), (2) back where it was."""
    q1, q2 = sp.symbols("q1 q2", real=True)
    standard = L_A * sp.Matrix([sp.cos(q2), sp.sin(q2)]) + L_D * sp.Matrix(
        [sp.cos(q1 + q2), sp.sin(q1 + q2)]
    )
    return same_matrix(
        _printed_tip().subs({TH1: q2, TH2: q1 + q2 + quarter_turns * sp.pi / 2}), standard
    )


def _printed_jacobian() -> sp.Matrix:
    return sp.Matrix(
        [[-L_A * sp.sin(TH1), -L_D * sp.cos(TH2)], [L_A * sp.cos(TH1), -L_D * sp.sin(TH2)]]
    )


def _printed_coupled_jacobian() -> sp.Matrix:
    a, b = L_A * sp.sin(TH1), L_D * sp.cos(TH2)
    c, d = L_A * sp.cos(TH1), L_D * sp.sin(TH2)
    return sp.Matrix([[-a + b, -a - b], [c + d, c - d]]) / 2


def _printed_force_jacobian() -> sp.Matrix:
    a, b = L_A * sp.sin(TH1), L_D * sp.cos(TH2)
    c, d = L_A * sp.cos(TH1), L_D * sp.sin(TH2)
    return sp.Matrix([[-2 * a, 2 * c], [-2 * b, -2 * d], [-a + b, c + d], [-a - b, c - d]]) / 2


def _pair_balances(pair: tuple[int, ...]) -> bool:
    """Whether these clutches alone, with the torques of (11), replace the tip force."""
    rows = g.CLUTCH_MAP.extract(list(pair), [0, 1])
    torques = _printed_force_jacobian().extract(list(pair), [0, 1])
    return same_matrix(rows.T * torques, kinematics.tip_jacobian().T)


def entries() -> list[Entry]:
    """Entries of equations (1)-(11)."""
    velocity = g.velocity(g.TIP)
    coupled = sp.Matrix([W1 - W2, W1 + W2])
    coupled_angles = sp.Matrix([TH1 - TH2, TH1 + TH2])
    two_ways = "symbolically, along links A and D and along links B, C and D"
    rates = "symbolically, from the derivative of the tip"
    return [
        Entry("1", "x of the tip", two_ways, lambda: _tip(0)),
        Entry("2", "y of the tip", two_ways, lambda: _tip(1)),
        Entry(
            "3", "elbow angle q1 = arccos(...)", "round trip at 300 poses",
            lambda: _q1_returns(True),
            condition="cos(th1 - th2) >= 0; the other elbow is -q1",
            conditional=lambda: _q1_returns(False),
        ),
        Entry(
            "4", "q2 = arcsin(...)", "round trip at 300 poses, q1 taken from the pose",
            lambda: _q2_returns(True),
            condition="|th1| <= pi/2; beyond it the arcsine folds q2 back: use atan2",
            conditional=lambda: _q2_returns(False),
            remark=f"on the thesis's own path th1 reaches {_largest_angle_on_the_path():.0f} deg "
            "(inferred lengths)",
        ),
        Entry("5", "th1 = q2", "symbolically: th1 solves (4)", _theta_1_satisfies_4),
        Entry(
            "6", "th2 = q1 + q2 + pi/2", "symbolically: tip of (1), (2) from q1, q2",
            lambda: _theta_2_is_q1_plus_q2(1),
            corrected="th2 = q1 + q2 - pi/2", correction=lambda: _theta_2_is_q1_plus_q2(-1),
            remark="the transcript shows a plus, and it never turns a minus into one; as printed "
            "link D points backwards, against (1), (2), (9)-(11)",
        ),
        Entry(
            "7", "th3 = th1 - th2", "its rate is row 3 of the clutch map",
            lambda: same_matrix(sp.Matrix([TH1 - TH2]).jacobian(Q), g.CLUTCH_MAP[2, :]),
        ),
        Entry(
            "8", "th4 = th1 + th2", "its rate is row 4 of the clutch map",
            lambda: same_matrix(sp.Matrix([TH1 + TH2]).jacobian(Q), g.CLUTCH_MAP[3, :]),
        ),
        Entry(
            "9", "tip velocity from th1', th2'", rates,
            lambda: same_matrix(g.TIP, _printed_jacobian() * Q), "dots",
            lambda: same_matrix(velocity, _printed_jacobian() * QD),
        ),
        Entry(
            "10", "tip velocity from th3', th4'", rates,
            lambda: same_matrix(g.TIP, _printed_coupled_jacobian() * coupled_angles),
            "dots",
            lambda: same_matrix(velocity, _printed_coupled_jacobian() * coupled),
            remark="as the text says, (9) and (10) can be inverted where cos(th1 - th2) is not 0",
        ),
        Entry(
            "11", "clutch torques from tip force", "symbolically, by virtual work",
            lambda: _pair_balances((0, 1, 2, 3)),
            condition="one pair at a time, clutches 1, 2 or 3, 4: each alone is equivalent to the "
            "force; all four together would be twice it",
            conditional=lambda: _pair_balances((0, 1)) and _pair_balances((2, 3)),
        ),
    ]  # fmt: skip
