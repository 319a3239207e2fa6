"""Scenarios and runs as files, read and written."""
