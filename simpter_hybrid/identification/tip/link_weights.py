"""Weights that a model of two links lacks, where their angles are relative."""

from __future__ import annotations

import numpy as np

from ...loads.link_weights import LinkWeights
from ...scenario import Scenario
from ..fitting.predictor import Parameter
from ..rigs.effect_candidate import EffectCandidate
from ..rigs.pose import every_pose

#: Poses in which the mass matrix is asked, and what of it is rounding.
POSES, ROUNDING = 8, 1e-9
#: Coordinates along which a weight shows.
SHOWN = ("position", "other_joint_position", "time")


def are_relative(declared: Scenario) -> bool:
    """Whether a device is two links in a plane, the angle of the second relative to the first.

    Its mass matrix says so: turned as a whole it is the same, and what the second joint's angle
    changes of the coupling it changes twice in the first joint's inertia, and not in its own.
    """
    kinds = declared.device.coordinate_dimensions or ("angle",) * declared.device.n
    if tuple(kinds) != ("angle", "angle"):
        return False
    poses = np.random.default_rng(1).uniform(-np.pi, np.pi, (POSES, 2))
    turned = poses + np.array([1.0, 0.0])
    here, there = (every_pose(declared, "mass_matrix", x, (2, 2)) for x in (poses, turned))
    most = ROUNDING * np.abs(here).max()
    coupling = here[:, 0, 1]
    same = here - there, np.ptp(here[:, 0, 0] - 2.0 * coupling), np.ptp(here[:, 1, 1])
    return bool(np.ptp(coupling) > most and all(np.all(np.abs(x) <= most) for x in same))


def weighs_nothing(declared: Scenario) -> bool:
    """Whether a device of two joints declares no force by its place in any pose.

    One with weights takes other ones for a tilt: of a pendulum whose weights were refitted it was
    said to stand tilted, by moments along its own weight.
    """
    if "conservative_force" not in declared.device.functions():
        return True
    poses = np.random.default_rng(1).uniform(-np.pi, np.pi, (POSES, 2))
    return not every_pose(declared, "conservative_force", poses, (2, 1)).any()


def link_weights(name: str, force: float) -> EffectCandidate:
    """Candidate: weights that go by the links' angles in space, as of a base that is tilted.

    `force`: a typical moment in the record [N m].
    """
    fields = ("cosine_1", "sine_1", "cosine_2", "sine_2")
    own = tuple(
        Parameter(f"{name}.{field}", 0.0, -force, force, 0.003 * force, unit="N*m")
        for field in fields
    )
    where = tuple(f"joint_{j}:{c}" for j in (1, 2) for c in SHOWN)
    return EffectCandidate(
        name, own, ((0.0,) * len(own),), "load by position", "load", where,
        "Slow sweeps over the whole range with all clutches off.", load=LinkWeights(),
    )  # fmt: skip
