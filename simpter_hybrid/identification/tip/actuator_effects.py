"""Effects of what presses a clutch, from its command on: their bounds hang on no record."""

from __future__ import annotations

from ...effects.command_scale import CommandScale
from ...effects.other_commands import OtherCommands
from ...effects.other_excitations import OtherExcitations
from ...effects.play_hysteresis import PlayHysteresis
from ...effects.pull_in import PullIn
from ...effects.release_asymmetry import ReleaseAsymmetry
from ...effects.remanence import Remanence
from ...effects.second_lag import SecondLag
from ...effects.slew_limit import SlewLimit
from ...effects.torque_lag import TorqueLag
from .made import SWITCHING

#: Rows as of `candidates.clutch_effects`.
ACTUATOR_EFFECTS = (
    # Begun inside the loop: one beside the declared map shifts all torque scales at once.
    ("play-hysteresis", PlayHysteresis, (("share", 0.0, 1.0, 0.02, 0.15),),
     (("width", 0.1, 8.0, 0.2, (0.7, 2.5)), ("lift", 0.0, 2.0, 0.1, (0.7,))),
     SWITCHING),
    ("remanence", Remanence, (("width", 0.0, 2.0, 0.02, 0.03),), (), SWITCHING),
    ("slew-limit", SlewLimit, (("slowness", 0.0, 0.2, 0.002, 0.012),
                               ("slowness_down", 0.0, 0.2, 0.002, 0.012)), (),
     SWITCHING),
    ("release-asymmetry", ReleaseAsymmetry, (("share", -0.8, 3.0, 0.03, 0.0),), (),
     SWITCHING),
    ("torque-lag", TorqueLag, (("share", 0.0, 1.0, 0.03, 0.05),), (), SWITCHING),
    ("second-lag", SecondLag, (("lag", 1e-4, 0.1, 0.002, 0.003),), (), SWITCHING),
    ("pull-in", PullIn, (("extra", -0.02, 0.1, 0.003, 0.003),
                         ("drop_out", 0.0, 1.0, 0.02, 0.0)), (),
     SWITCHING),
    ("other-commands", OtherCommands, (("gain", -0.5, 0.5, 0.01, 0.0),
                                       ("relative", -0.1, 0.1, 0.002, 0.0)), (),
     SWITCHING),
    ("other-excitations", OtherExcitations, (("gain", -0.5, 0.5, 0.01, 0.0),
                                             ("relative", -0.1, 0.1, 0.002, 0.0)), (),
     SWITCHING),
    ("command-scale", CommandScale, (("gain", -0.5, 0.5, 0.01, 0.0),
                                     ("offset", -2.0, 2.0, 0.01, 0.0)), (),
     SWITCHING),
)  # fmt: skip
