"""Recordings: read, mapped to signals, and checked for gaps, jumps, clipping and noise."""
