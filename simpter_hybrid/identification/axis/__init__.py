"""Rigs of one axis or two driven joints: moved by a drive, set points, a tester, or let alone."""
