"""Other ways of simulating friction, measured against the exact run of the same scenario."""

from .candidates import Candidate, karnopp, regularised
from .compare import Comparison, Row, compare

__all__ = ["Candidate", "Comparison", "Row", "compare", "karnopp", "regularised"]
