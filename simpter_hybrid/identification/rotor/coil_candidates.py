"""Effects between a command and the excitation of a clutch, and where their fits begin."""

from __future__ import annotations

from dataclasses import replace

from ...effects.coil_supply import CoilSupply
from ...effects.command_scale import CommandScale
from ...effects.command_slew import CommandSlew
from ...effects.dwell_breakaway import DwellBreakaway
from ...effects.excitation_power import ExcitationPower
from ...effects.neighbour_command import NeighbourCommand
from ...effects.play_hysteresis import PlayHysteresis
from ...effects.pull_in import PullIn
from ...effects.rate_breakaway import RateBreakaway
from ...effects.release_asymmetry import ReleaseAsymmetry
from ...effects.remanence import Remanence
from ...effects.second_lag import SecondLag
from ...effects.slew_limit import SlewLimit
from ...effects.torque_lag import TorqueLag
from ...laws import LBF_IN
from ..fitting.predictor import Parameter
from ..rigs.candidate import candidate
from ..rigs.declared_off import TIME_CONSTANT
from ..rigs.effect_candidate import EffectCandidate
from .contact_candidates import C
from .sizes import FULL_SCALE, Sizes

#: How fast a load rises from which on a breakaway goes by the logarithm of it [lbf in/s].
SLOPE = 10.0
#: Where a lack of what switches a clutch shows.
SWITCHING = ("excitation_rate", "drive")
#: Where a torque shows that depends on how its excitation was reached.
BRANCHING = ("excitation_branch", "excitation_rate")


def of_magnets(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Excitation that depends on what was before."""
    V = sizes.command
    return (
        candidate("play-hysteresis", PlayHysteresis(**C),
             (("share", 0.0, 1.0, 0.05), ("width", 0.1 * V, 8.0 * V, 0.3 * V)),
             ((0.15, 1.0 * V), (0.15, 3.0 * V)), BRANCHING),
        candidate("play-hysteresis-2", PlayHysteresis(**C),
             (("share", 0.0, 1.0, 0.05), ("width", 0.1 * V, 8.0 * V, 0.3 * V),
              ("lift", 0.0, 2.0, 0.2)),
             ((0.15, 1.0 * V, 0.7), (0.15, 3.0 * V, 0.7)),
             BRANCHING, simpler="play-hysteresis"),
        candidate("remanence", Remanence(**C), (("width", 0.0, 2.0 * V, 0.03 * V),), ((0.05 * V,),),
             BRANCHING),
    )  # fmt: skip


def of_switching(sizes: Sizes, lag: str | None) -> tuple[EffectCandidate, ...]:
    """Effects of what drives a coil, and of how torque follows it.

    `lag`: name of the tolerance to which the clutch's time constant is declared, if it is to one.
    """
    V = sizes.command
    # Beside a limit of what drives a coil its lag is another than the one that held both.
    free = () if lag is None else (Parameter(lag, 1.0, 0.05, 1.7, 0.05),)
    slow, ramp = (0.01 / V, 0.01 / V), (0.005 / V, 0.005 / V)
    return (
        candidate("slew-limit", SlewLimit(**C),
             (("slowness", 0.0, 0.2 / V, 0.001 / V), ("slowness_down", 0.0, 0.2 / V, 0.001 / V)),
             (slow if lag is None else (*slow, 0.3),), SWITCHING, free, contains=(TIME_CONSTANT,)),
        candidate("command-slew", CommandSlew(**C),
             (("slowness", 0.0, 0.2 / V, 0.001 / V), ("slowness_down", 0.0, 0.2 / V, 0.001 / V)),
             (ramp if lag is None else (*ramp, 0.8),), SWITCHING, free, contains=(TIME_CONSTANT,)),
        candidate("coil-supply", CoilSupply(**C),
             (("inductive", 0.01, 0.5, 0.005), ("clamp", 10.0 * V, 60.0 * V, 0.5 * V),
              ("stiffness", 0.0, 50.0, 0.5)), ((0.124, 15.0 * V, 3.0),),
             SWITCHING, contains=(TIME_CONSTANT,)),
        candidate("release-asymmetry", ReleaseAsymmetry(**C), (("share", -0.8, 3.0, 0.05),),
             ((0.0,),), SWITCHING),
        candidate("torque-lag", TorqueLag(**C), (("share", 0.0, 1.0, 0.05),), ((0.1,),),
             SWITCHING),
        candidate("second-lag", SecondLag(**C), (("lag", 1e-4, 0.1, 0.002),), ((0.005,),),
             SWITCHING),
        candidate("pull-in", PullIn(**C),
             (("extra", -0.02, 0.1, 0.002), ("drop_out", 0.0, V, 0.02 * V)),
             ((0.0, 0.0),), SWITCHING),
    )  # fmt: skip


def of_commands(sizes: Sizes) -> tuple[EffectCandidate, ...]:
    """Another command than was logged, and a breakaway that goes by rest or by haste."""
    V, L = sizes.command, LBF_IN * sizes.torque
    # A power leaves the middle of the range alone: beside it the scale of the torque is its own.
    power = ExcitationPower(reference=0.5 * FULL_SCALE * V, **C)
    rate = RateBreakaway(scale=SLOPE * L, **C)
    return (
        candidate("neighbour-command", NeighbourCommand(**C), (("gain", -0.8, 0.8, 0.02),),
             ((0.0,),), ("neighbour_command",)),
        replace(
            candidate("neighbour-command-2", NeighbourCommand(**C),
                 (("gain", -0.8, 0.8, 0.02), ("lag", 1e-3, 0.5, 0.01)),
                 ((0.02, 0.02), (-0.02, 0.02)), ("neighbour_command",),
                 simpler="neighbour-command"),
            plain="neighbour-command"),
        candidate("command-scale", CommandScale(**C),
             (("gain", -0.5, 0.5, 0.01), ("offset", -2.0 * V, 2.0 * V, 0.02 * V)),
             ((0.0, 0.0),), ("excitation", "torque")),
        candidate("command-offset", CommandScale(**C), (("offset", -2.0 * V, 2.0 * V, 0.02 * V),),
             ((0.0,),), ("excitation", "torque")),
        candidate("press-power", power, (("change", -0.8, 1.0, 0.02),), ((0.0,),),
             ("excitation", "torque")),
        candidate("dwell-breakaway", DwellBreakaway(**C), (("rise", 0.0, 0.5, 0.01),), ((0.02,),),
             ("rest", "level")),
        candidate("rate-breakaway", rate,
             (("fall", 0.0, 0.5, 0.01), ("reference", 0.0, 5e3 * L, 20.0 * L)),
             ((0.02, 0.0), (0.02, 100.0 * L)), ("load_rate", "level")),
    )  # fmt: skip
