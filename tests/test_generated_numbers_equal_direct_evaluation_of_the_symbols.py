"""What the generated code computes is what SymPy evaluates, at random states."""

import numpy as np
import pytest
import sympy as sp
from pter_states import filled, random_states

from derivations import geometry, kinematics, lagrangian, symbols
from derivations.bindings import LAYOUT
from simpter_hybrid.devices import pter_equations

MOTION = lagrangian.from_lumped()
QD = symbols.QD
CASES = {
    "mass_matrix": (MOTION.mass_matrix, "q p"),
    "velocity_terms": (MOTION.velocity_terms, "q qd p"),
    "clutch_map": (geometry.CLUTCH_MAP, "q p"),
    "clutch_map_rate": (kinematics.clutch_map_rate(), "q qd p"),
    "tip": (geometry.TIP, "q p"),
    "tip_jacobian": (kinematics.tip_jacobian(), "q p"),
    "tip_jacobian_rate": (kinematics.tip_jacobian_rate(), "q qd p"),
    "kinetic_energy": ((QD.T * MOTION.mass_matrix * QD)[0] / 2, "q qd p"),
    "singularity": (kinematics.determinant() / (symbols.L_A * symbols.L_D), "q p"),
}


def substitutions(state):
    # exact rationals and 30 digits: SymPy's own rounding does not enter the comparison
    return {
        symbol: sp.Rational(float(getattr(state, place.split("[")[0])[int(place[-2])]))
        for layout in LAYOUT.values()
        for symbol, place in layout.items()
    }


@pytest.mark.parametrize("name", CASES)
def test_the_code_agrees_with_the_symbols(name):
    expression, arguments = CASES[name]
    entries = sp.Matrix(expression) if isinstance(expression, sp.MatrixBase) else None
    for state in random_states(20, seed=1):
        values = substitutions(state)
        numbers = [getattr(state, argument) for argument in arguments.split()]
        function = getattr(pter_equations, name)
        if entries is None:
            direct = np.array([float(sp.N(sp.sympify(expression).subs(values), 30))])
            computed = np.array([function(*numbers)])
        else:
            direct = np.array([float(sp.N(e.subs(values), 30)) for e in entries])
            computed = filled(function, len(entries), *numbers)
        # a dozen floating-point operations on numbers of size up to 1000
        scale = max(1.0, np.abs(direct).max(), state.p[0] * 36.0)
        assert np.abs(computed - direct).max() <= 20 * np.finfo(float).eps * scale
