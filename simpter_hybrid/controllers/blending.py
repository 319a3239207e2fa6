"""Blending: a clutch is applied and released gradually instead of by a step."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

from ..controller import Controller
from ..part import parameter


@dataclass(frozen=True)
class Blending(Controller):
    """A stage between a torque selector and the clutch controller that fades clutches in and out.

    Every clutch has a weight that rises to 1 within ``apply`` while the selector wants the clutch
    and falls to 0 within ``release`` when it no longer does; the desired torque handed on is the
    weight times what the selector asks, or asked last. Changes while a clutch is applied pass.
    Source: thesis 2.2 (Gomes's blending, "which gradually applied and released clutches"; its
    detail is lost) and 6.2.2.2 (the same for the velocity controller). Clutches beyond the eighth
    pass unchanged.

    Parameters
    ----------
    apply, release : float
        Durations of a full fade [s]; 0 steps.
    """

    apply: float = parameter("time", low=0.0)
    release: float = parameter("time", low=0.0)

    rewrites: ClassVar[tuple[str, ...]] = ("desired",)
    memory: ClassVar[tuple[str, ...]] = (
        "last",
        *(f"weight_{i + 1}" for i in range(8)),
        *(f"torque_{i + 1}" for i in range(8)),
    )

    @staticmethod
    def step(time, held, mem, mem_at, at_desired_1, desired_count, apply, release):
        passed = time - mem[mem_at]
        mem[mem_at] = time
        for i in range(min(desired_count, 8)):
            wanted = held[at_desired_1 + i]
            weight = mem[mem_at + 1 + i]
            if wanted > 0.0:
                weight = min(weight + passed / apply, 1.0) if apply > 0.0 else 1.0
                mem[mem_at + 9 + i] = wanted
            else:
                weight = max(weight - passed / release, 0.0) if release > 0.0 else 0.0
            mem[mem_at + 1 + i] = weight
            held[at_desired_1 + i] = weight * mem[mem_at + 9 + i]
