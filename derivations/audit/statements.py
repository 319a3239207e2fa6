"""Sentences of the thesis against its own figures and tables, and against the derivation."""

from __future__ import annotations

import math

import sympy as sp

from derivations import kinematics, lagrangian
from derivations import symbols as s
from derivations.audit import controller_tables, path
from derivations.audit.calibration import SLOPE_38
from derivations.audit.clutch_forces import passive
from derivations.audit.clutch_maps import breakaway, dynamic
from derivations.audit.compare import rounds_to, same
from derivations.audit.electromagnet import CURRENT, INDUCTANCE, X
from derivations.audit.verdict import CONTRADICTED, Entry
from derivations.geometry import CLUTCH_MAP
from derivations.stuck_sets import stuck_set


def _sensor_volts(volts: float) -> tuple[float, float]:
    """Torque sensor output [V] at a clutch excitation, over the speeds tested."""
    return dynamic(volts, 0.194) / SLOPE_38, dynamic(volts, 1.990) / SLOPE_38


def _fits_figure_24(volts: float) -> bool:
    """Whether the plateau may lie inside the figure's axis, which ends at -1.5 V."""
    return _sensor_volts(volts)[0] <= 1.5


def _constant_direction(clutch: int) -> bool:
    """Whether the motion with this clutch stuck has th1' = -th2', the condition of Case 3.2."""
    direction = stuck_set(CLUTCH_MAP, (clutch - 1,)).null_space
    return sp.Matrix([[1, 1]]) * direction == sp.zeros(1, 1)


def _in_figure_53(sign: int) -> bool:
    """Whether the tip lies in the figure's window (3.8-5.8, 36.8-38.8 in), inferred lengths."""
    l_a, l_d = path.LENGTHS
    th1, th2 = sign * math.pi / 4, sign * math.pi / 3
    x = l_a * math.cos(th1) - l_d * math.sin(th2)
    y = l_a * math.sin(th1) + l_d * math.cos(th2)
    return 3.8 <= x <= 5.8 and 36.8 <= y <= 38.8


def _no_lengths_help() -> bool:
    """-pi/4, -pi/3: from x <= 5.8 follows l_D <= 6.7 in, so y <= l_D / 2 is below 36.8 in."""
    largest_l_d = 5.8 / math.sin(math.pi / 3)
    return largest_l_d * math.cos(math.pi / 3) < 36.8


INCH, RADIAN, SECOND = sp.symbols("in rad s", positive=True)


def _third_derivative(unit: sp.Symbol) -> sp.Expr:
    """Unit of the third derivative in time of a quantity in ``unit``."""
    value, time = sp.symbols("value time", positive=True)
    rate = (value * unit * (time / SECOND) ** 3).diff(time, 3)
    return rate / (6 * value)


def _along_path(direction: tuple[float, float]) -> bool:
    """Whether the path from (3, 24) to (-28, 24) runs along a direction."""
    along = (path.STOP - path.START, path.HEIGHT - path.HEIGHT)
    return along[0] * direction[1] - along[1] * direction[0] == 0.0


def _normal_to_path(direction: tuple[float, float]) -> bool:
    """Whether a force direction is normal to that path."""
    along = (path.STOP - path.START, path.HEIGHT - path.HEIGHT)
    return along[0] * direction[0] + along[1] * direction[1] == 0.0


def _straight_line_fits(stop: float) -> bool:
    """Whether the shortest path to x = stop is within 1 % of the best controller's 31.034 in."""
    shortest = path.START - stop
    return 0.0 <= 31.034 / shortest - 1.0 < 0.01


def _normal_force_grows(power: int) -> bool:
    force = CURRENT**2 * INDUCTANCE.diff(X) / 2
    return same(force.subs(CURRENT, 2 * CURRENT), 2**power * force)


def _only_v_moves_link_b() -> bool:
    """At breakaway of clutch 1 (speeds zero, torque on link A only): is th2'' zero without V?"""
    motion = lagrangian.from_lumped()
    at_rest = {s.W1: 0, s.W2: 0}
    acceleration = motion.mass_matrix.inv() * sp.Matrix([s.G1, 0])
    return motion.velocity_terms.subs(at_rest) == sp.zeros(2, 1) and same(acceleration[1], 0)


def _lags() -> list[Entry]:
    """Statements about the measured step responses (4.6.1, 5.1)."""
    return [
        Entry(
            "4.6.1, half", "the delay from 2 V, 12 ms, is half that of the from-zero tests",
            "0.012 s against 0.020 s and 0.022 s",
            lambda: all(rounds_to(0.012 / d, "0.5") for d in (0.020, 0.022)),
            condition="compared with the 22 ms of the 8 V step (0.55); it is 0.6 of the other",
            conditional=lambda: rounds_to(0.012 / 0.022, "0.5"), fault=CONTRADICTED,
        ),
        Entry("4.6.1, third", "4 ms of the recorder are one third of the residual delay",
              "arithmetic", lambda: rounds_to(0.004 / 0.012, "0.33"), fault=CONTRADICTED),
        Entry("4.6.1, 0.01 s", "delays from zero and from 2 V differ by about 0.01 s",
              "0.022 s - 0.012 s", lambda: rounds_to(0.022 - 0.012, "0.01"), fault=CONTRADICTED),
        Entry(
            "5.1", "0.07 s is the upper bound of the measured time constants",
            "largest measured: 0.065 s", lambda: max(0.022, 0.050, 0.053, 0.065) == 0.07,
            condition="rounded up to a hundredth",
            conditional=lambda: math.ceil(100 * 0.065) / 100 == 0.07, fault=CONTRADICTED,
        ),
        Entry("4.2", "Gomes's time constants lie in 0.25 to 2.5 s", "3.2.3.1 says 0.24 to 2.4 s",
              lambda: (0.25, 2.5) == (0.24, 2.4), fault=CONTRADICTED),
    ]  # fmt: skip


def _run() -> list[Entry]:
    """Statements about the standard run and its figures (chapter 5)."""
    return [
        Entry(
            "5.2.1, y-axis", "the desired path lies along the y-axis",
            "direction from the start (3, 24) to the stop (-28, 24) of 5.3.2",
            lambda: _along_path((0.0, 1.0)), corrected="parallel to the x-axis",
            correction=lambda: _along_path((1.0, 0.0)), fault=CONTRADICTED,
        ),
        Entry(
            "3.2.1, tangent", "a constant force parallel to the path and a tangent one of "
            "sinusoids", "5.2.1 wants a disturbance normal to that path",
            lambda: _normal_to_path((1.0, 0.0)), corrected="sinusoids normal to the path",
            correction=lambda: _normal_to_path((0.0, 1.0)), fault=CONTRADICTED,
        ),
        Entry(
            "Figure 7", "simulation stops at x = -26 in", "path lengths of Table 6",
            lambda: _straight_line_fits(-26.0), corrected="x = -28 in",
            correction=lambda: _straight_line_fits(-28.0), fault=CONTRADICTED,
        ),
        Entry(
            "5.3.2, clutch 4", "flats at zero velocity: twice clutch 2, four times clutch 4",
            "slip velocities along y = 24 in, all lengths in the inferred ranges",
            lambda: path.changes_sign(2) and path.changes_sign(4),
            corrected="twice clutch 2, four times clutch 3, the two that Figure 39 shows",
            correction=lambda: path.changes_sign(2) and path.changes_sign(3)
            and not path.changes_sign(1) and not path.changes_sign(4),
            fault=CONTRADICTED,
            remark="the slip velocity of clutch 4 keeps its sign on the whole path",
        ),
        Entry("5.4.2, 6", "six transitions in the baseline run", "2 + 4 of 5.3.2",
              lambda: 2 + 4 == 6, fault=CONTRADICTED),
        Entry(
            "Figure 39, unit", "linear jerk in rad/s^3", "third derivative of a length in inches",
            lambda: _third_derivative(INCH) == RADIAN / SECOND**3,
            corrected="in/s^3, as in Figure 40",
            correction=lambda: _third_derivative(INCH) == INCH / SECOND**3,
            fault=CONTRADICTED,
        ),
        Entry(
            "5.4.3, 0.20", "the runs of Figure 50 had gain 0.20",
            "gains listed in the same paragraph and in the figure: 0, 0.08, 0.25",
            lambda: 0.20 in (0.0, 0.08, 0.25), corrected="0.25; 0.20 belongs to Figure 49",
            correction=lambda: 0.25 in (0.0, 0.08, 0.25), fault=CONTRADICTED,
        ),
        Entry(
            "Figure 53, pose", "th1 = -pi/4, th2 = -pi/3", "tip against the figure's window",
            lambda: _in_figure_53(-1), corrected="th1 = pi/4, th2 = pi/3",
            correction=lambda: _in_figure_53(1) and _no_lengths_help(), fault=CONTRADICTED,
            remark="no positive link lengths put the tip of the printed pose into the figure",
        ),
        Entry("Figure 53, forces", "all four clutch forces slow the tip down",
              "power on the tip in random states, force Jacobian",
              lambda: all(passive(i, True, dots=True) for i in (1, 2, 3, 4)), fault=CONTRADICTED),
        Entry("5.5.1, 45", "equal tangential and normal components give 45 degrees",
              "arctangent", lambda: math.isclose(math.atan2(1, 1), math.pi / 4),
              fault=CONTRADICTED),
    ]  # fmt: skip


def _model() -> list[Entry]:
    """Statements about kinematics, dynamics and clutches (chapters 2-4, Appendix A)."""
    pairs = [(i, j) for i in range(4) for j in range(i + 1, 4)]
    return [
        Entry(
            "2.1.2", "the matrices of (9) and (10) can be inverted", "their determinants",
            lambda: kinematics.determinant().is_nonzero is True, condition="cos(th1 - th2) != 0",
            conditional=lambda: same(
                kinematics.determinant(), s.L_A * s.L_D * sp.cos(s.TH1 - s.TH2)
            ) and same(2 * kinematics.jacobian_of_clutches(3, 4).det(), kinematics.determinant()),
            fault=CONTRADICTED,
        ),
        Entry("2.1.2, (11)", "clutch torques do not follow uniquely from a tip force",
              "null space of C'", lambda: len(CLUTCH_MAP.T.nullspace()) == 2, fault=CONTRADICTED),
        Entry("3.2.3.4, 0 DOF", "more than one stuck clutch leaves no freedom",
              "rank of every pair", lambda: all(stuck_set(CLUTCH_MAP, p).rank == 2 for p in pairs),
              fault=CONTRADICTED),
        Entry(
            "3.2.3.4, zero", "no current, no torque", "(39) and (43) at 0 V",
            lambda: breakaway(0.0) == dynamic(0.0, 0.0) == 0.0,
            condition="as an approximation: below 1 % of the torque at 10 V, and it jumps",
            conditional=lambda: 0 < breakaway(0.0) < 0.01 * breakaway(10.0), fault=CONTRADICTED,
        ),
        Entry(
            "3.2.3.1", "normal force proportional to the current", "equation (34)",
            lambda: _normal_force_grows(1), corrected="proportional to the current's square",
            correction=lambda: _normal_force_grows(2), fault=CONTRADICTED,
        ),
        Entry(
            "3.3", "after breakaway of clutch 1 the V terms move link B",
            "symbolically, at the instant of breakaway",
            _only_v_moves_link_b,
            corrected="V is zero at that instant; the coupling M12 = gamma sin(th2 - th1) moves it",
            correction=lambda: not _only_v_moves_link_b()
            and same(
                (lagrangian.from_lumped().mass_matrix.inv() * sp.Matrix([s.G1, 0]))[1].subs(
                    s.GAMMA, 0), 0),
            fault=CONTRADICTED,
        ),
        Entry(
            "4.6.2.1, 9 V", "Figure 24 was taken at an excitation of 9 volts",
            "plateau by (39) and (38) against the figure's axis; its title says 6.0 v",
            lambda: _fits_figure_24(9.0), corrected="6 volts",
            correction=lambda: _fits_figure_24(6.0), fault=CONTRADICTED,
        ),
        Entry(
            "A.5", "clutch three is in the stick mode when th1'' = -th2''",
            "motion left by a stuck clutch", lambda: _constant_direction(3),
            corrected="clutch four", correction=lambda: _constant_direction(4),
            fault=CONTRADICTED,
        ),
    ]  # fmt: skip


def entries() -> list[Entry]:
    """Entries of the statements."""
    return [*_model(), *_lags(), *_run(), *controller_tables.entries()]
