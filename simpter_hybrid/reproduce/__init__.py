"""The thesis's results side by side with what comes out here: ``reproduce(name) -> rows``."""

from .registry import ALIASES, REPRODUCTIONS, reproduce
from .rows import FAILS, HOLDS, UNCOMPARABLE, Row

__all__ = ["ALIASES", "FAILS", "HOLDS", "REPRODUCTIONS", "UNCOMPARABLE", "Row", "reproduce"]
