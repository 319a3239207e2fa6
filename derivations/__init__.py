"""Derivation of PTER's equations in SymPy, and the code generated from it.

The only place of the project that imports SymPy (besides the helper that derives a user's own
device). ``python -m derivations`` writes the generated modules, ``--check`` shows whether they are
fresh, ``--audit`` compares the derivation with every equation that the thesis prints.
"""
