"""Coefficients of the DOP853 pair, as SciPy holds them (Hairer, Norsett & Wanner 1993)."""

import numpy as np
from scipy.integrate._ivp import dop853_coefficients as hairer

STAGES = hairer.N_STAGES
EXTENDED = hairer.N_STAGES_EXTENDED
POWER = hairer.INTERPOLATOR_POWER
A = np.ascontiguousarray(hairer.A)
B = np.ascontiguousarray(hairer.B)
C = np.ascontiguousarray(hairer.C)
E3 = np.ascontiguousarray(hairer.E3)
E5 = np.ascontiguousarray(hairer.E5)
D = np.ascontiguousarray(hairer.D)
