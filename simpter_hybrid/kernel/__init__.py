"""The hybrid automaton's numerics, written once for both engines.

Every function here is valid Python on lists of floats and valid Numba on one-dimensional
``float64``/``int64`` arrays: matrices are flat and row-major, results are written in place,
failures are integer status codes.  The reference engine calls the functions as they stand; the
compiled engine compiles the same source (``simpter_hybrid.compiled``).
"""
