"""The force that a sampled hand holds on the tip."""

from __future__ import annotations

from dataclasses import dataclass

from ..applied_load import Load


@dataclass(frozen=True)
class HeldTipForce(Load):
    """Tip force equal to the held inputs ``hand_x``, ``hand_y`` [N] (``controllers.hand``)."""

    @staticmethod
    def tip_force(held_hand_x, held_hand_y, out):
        out[0] = held_hand_x
        out[1] = held_hand_y
