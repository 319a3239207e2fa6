"""Loads: forces on the tip or along coordinates, one file each."""
