"""A run as one HTML file: its text, and the data of the part that moves."""
