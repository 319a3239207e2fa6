"""Replays, residuals and fits: what a model leaves of recorded runs, and refitted values."""
