"""A run in progress: its segments, its record, and in words why it cannot go on."""
