"""What the thesis leaves for later (its 6.3), tried: ``study(name) -> Study``."""

from .registry import STUDIES, study
from .study import Study, Table

__all__ = ["STUDIES", "Study", "Table", "study"]
