"""Audit of the thesis: every printed equation, count and table against the derivation.

The verdicts are not written down anywhere: each follows from the outcomes of checks (verdict.py).
"""
