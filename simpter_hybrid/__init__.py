"""Exact event-driven simulation of devices with controlled friction."""
