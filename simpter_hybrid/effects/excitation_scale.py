"""What presses a clutch acts with another gain, and from another zero."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..effect import Effect
from ..part import parameter
from .command_scale import rescaled


@dataclass(frozen=True)
class ExcitationScale(Effect):
    """The clutch acts as if excited by ``(1 + gain) excitation + offset``, never below 0.

    What does not press at all (an excitation of 0) stays so.  Behind a lag an excitation never
    quite gets there: of such a clutch ``command-scale`` has the same zero before it.

    Parameters
    ----------
    gain : float
        Relative excess.
    offset : float
        [V].
    """

    gain: float = parameter("dimensionless", 0.0, low=-0.9, high=5.0, typical=0.03)
    offset: float = parameter("voltage", 0.0, typical=0.1)

    sizes: ClassVar[tuple[str, ...]] = ("gain", "offset")
    family: ClassVar[str] = "press scale"
    acts_on: ClassVar[str] = "friction"
    reveals: ClassVar[str] = "The same sliding run at three levels of what presses, or more."
    uses: ClassVar[tuple] = (rescaled,)

    @staticmethod
    def effective_excitation(excitation, gain, offset):
        return rescaled(excitation, gain, offset)
