"""Effects that are tried between what presses an axis's friction and the friction itself."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from ...effects.command_scale import CommandScale
from ...effects.excitation_power import ExcitationPower
from ...effects.excitation_scale import ExcitationScale
from ...effects.play_hysteresis import PlayHysteresis
from ...effects.second_lag import SecondLag
from ...scenario import Scenario
from ..fitting.replay import Replay
from ..rigs.candidate import candidate
from ..rigs.declared_off import LAG, LAGS, TIME_CONSTANT, off_by_a_share
from ..rigs.effect_candidate import EffectCandidate
from .candidates import of_one_balance

#: What shows a lag.
STEPS = "Steps of what presses, up and down, while it slips."
#: What changes by less than this part of its largest value within every run tells of no memory.
STEADY = 0.05


def of_what_presses(declared: Scenario, replays: Sequence[Replay]) -> tuple[EffectCandidate, ...]:
    """Candidates between what presses and the friction, and a lag declared of it that is off.

    Parameters
    ----------
    declared : Scenario
    replays : sequence of Replay
        Fitted runs; what presses is their input ``press`` [V].
    """
    lagging = declared.clutches[0].time_constant > 0.0
    return (*pressed_candidates(replays, lagging), *lag_off(declared, replays))


def pressed_candidates(
    replays: Sequence[Replay], lagging: bool = False
) -> tuple[EffectCandidate, ...]:
    """A scale, a power, a lag and a memory of what presses; none where nothing does.

    Parameters
    ----------
    replays : sequence of Replay
        Fitted runs; what presses is their input ``press`` [V].
    lagging : bool
        Whether the clutch follows what presses through a lag.
    """
    most, changes = _pressing(replays)
    return pressed_library(most, changes, lagging) if most > 0.0 else ()


def _pressing(replays: Sequence[Replay]) -> tuple[float, bool]:
    """The largest of what presses [V], and whether it changes within runs."""
    most = max(float(np.abs(r.inputs["press"]).max()) for r in replays)
    moved = max(float(np.ptp(r.inputs["press"])) for r in replays)
    return most, moved >= STEADY * most > 0.0


def lag_off(declared: Scenario, replays: Sequence[Replay]) -> tuple[EffectCandidate, ...]:
    """Candidate: what presses follows its command by another time constant than declared.

    None where none is declared, or what presses does not change within runs.
    """
    if declared.clutches[0].time_constant == 0.0 or not _pressing(replays)[1]:
        return ()
    numbers = ["clutch.1.time_constant"]
    where = ["force:excitation_rate", "force:excitation_branch"]
    return (off_by_a_share(TIME_CONSTANT, numbers, LAGS, 0.3, LAG, "actuator", where, STEPS),)


def pressed_library(
    most: float, changes: bool, lagging: bool = False
) -> tuple[EffectCandidate, ...]:
    """Candidates for what presses by up to `most` [V]; `changes`: whether it does within runs."""
    # Behind a lag nothing is ever quite let go: there another zero acts on the command.
    scale = candidate("press-scale", (CommandScale if lagging else ExcitationScale)(clutch=0),
                      (("gain", -0.5, 0.5, 0.01), ("offset", -0.3 * most, 0.3 * most, 0.01 * most)),
                      ((0.0, 0.0),), ("excitation", "torque"))  # fmt: skip
    by_power = ExcitationPower(clutch=0, reference=most)
    fields = (("change", -0.8, 1.0, 0.03),)
    power = candidate("press-power", by_power, fields, ((0.0,),), ("excitation", "torque"))
    if not changes:
        return of_one_balance(scale), of_one_balance(power)
    memory = ("excitation_branch", "excitation_rate")
    made = (
        scale,
        power,
        candidate("press-lag", SecondLag(clutch=0), (("lag", 1e-4, 5.0, 0.005),),
                  ((0.01,), (0.1,)), ("excitation_rate", "excitation_branch")),
        candidate("press-hysteresis", PlayHysteresis(clutch=0),
                  (("share", 0.0, 1.0, 0.05), ("width", 0.01 * most, 0.7 * most, 0.03 * most)),
                  ((0.15, 0.1 * most), (0.3, 0.2 * most), (0.3, 0.4 * most)), memory),
    )  # fmt: skip
    return tuple(of_one_balance(one) for one in made)
