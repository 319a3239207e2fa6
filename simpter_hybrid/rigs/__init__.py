"""Test rigs and standard runs of the thesis, as functions that return scenarios."""
