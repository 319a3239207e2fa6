"""Friction made smooth, with a stiff solver: the other thing people do."""

from .simulate import simulate

__all__ = ["simulate"]
