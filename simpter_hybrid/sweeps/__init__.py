"""Sweeps: one scenario, thousands of cases, a file each; a killed one goes on where it was."""
