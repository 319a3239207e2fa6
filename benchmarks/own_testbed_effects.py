"""What an own recording may hide: at strength 1 the residual is some two times the floor."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from own_testbed_physics import Numbers

LBF_IN = 4.4482216152605 * 0.0254


@dataclass(frozen=True)
class Kind:
    """A hidden effect.

    Parameters
    ----------
    size : mapping of str to float
        Fields of `Numbers` at strength 1; they grow with it.
    names : tuple of str
        Effects of the library that are right; none: it is in nobody's list.
    depends : tuple of str
        Coordinates on which an unknown effect may be said to depend.
    signed : bool
        The sign is drawn.
    turned : bool
        Fields come in pairs (cosine, sine): the phase of each is drawn.
    shape : tuple of str
        Fields that are scaled by 0.8 to 1.25, drawn, whatever the strength.
    measure : tuple of str and float
        Parameter of the library and its true value at strength 1, where one can be stated.
    declared : bool
        A declared value that is off by far more than its tolerance, and no effect.
    """

    size: Mapping[str, float]
    names: tuple[str, ...] = ()
    depends: tuple[str, ...] = ()
    signed: bool = False
    turned: bool = False
    shape: tuple[str, ...] = ()
    measure: tuple[str, float] | None = None
    by_run: tuple[str, ...] = field(default=())
    declared: bool = False


SPEEDS = ("stribeck", "degressive-speed", "logarithmic-speed")
IMBALANCE = ("imbalance", "imbalance-2", *(f"imbalance-ripple-{n}" for n in range(2, 13)))
HYSTERESIS = ("play-hysteresis", "play-hysteresis-2", "remanence")
SUPPLY = ("slew-limit", "coil-supply")
PRESLIDING = ("presliding", "presliding-2", "presliding-springs")

KINDS: dict[str, Kind] = {
    "stribeck": Kind({"stribeck": 0.14}, SPEEDS, shape=("stribeck_speed",),
                     measure=("stribeck.rise", 0.14)),
    "degressive-speed": Kind({"degressive": 0.20}, SPEEDS, signed=True,
                             shape=("degressive_speed",)),
    "asymmetry": Kind({"asymmetry": 0.025}, ("asymmetry",), signed=True,
                      measure=("asymmetry.share", 0.025)),
    "position-friction": Kind({"once_cos": 0.0, "once_sin": 0.04, "twice_cos": 0.0,
                               "twice_sin": 0.008}, ("position-friction", "position-friction-2"),
                              turned=True),
    "position-friction-2": Kind({"once_cos": 0.0, "once_sin": 0.025, "twice_cos": 0.0,
                                 "twice_sin": 0.035, "thrice": 0.004}, ("position-friction-2",),
                                turned=True),
    "thermal-fade": Kind({"fade": 0.09}, ("thermal-fade",), shape=("cool_fast", "cool_slow")),
    "wear-in": Kind({"wear": 0.08}, ("wear-in", "warm-up"), signed=True, shape=("wear_path",)),
    "warm-up": Kind({"warm": 0.08}, ("warm-up", "wear-in"), signed=True, shape=("warm_work",)),
    "drift": Kind({"drift": 0.005}, ("drift",), signed=True),
    "dwell-breakaway": Kind({"dwell": 0.12}, ("dwell-breakaway",)),
    "presliding": Kind({"displacement": 0.006}, PRESLIDING),
    "play-hysteresis": Kind({"play": 0.16}, HYSTERESIS),
    "remanence": Kind({"remanence": 0.12}, HYSTERESIS, measure=("remanence.width", 0.12)),
    "pull-in": Kind({"late": 0.015, "drop_out": 0.3}, ("pull-in",)),
    "slew-limit": Kind({"slew": 0.017}, SUPPLY),
    "release-asymmetry": Kind({"release": 0.4}, ("release-asymmetry", "torque-lag"),
                              measure=("release-asymmetry.share", 0.4)),
    "second-lag": Kind({"second_lag": 0.014}, ("second-lag",), measure=("second-lag.lag", 0.014)),
    "neighbour-command": Kind({"coupling": 0.05}, ("neighbour-command",), signed=True),
    "command-scale": Kind({"offset": 0.25}, ("command-scale", "command-offset"), signed=True,
                          measure=("command-scale.offset", 0.25)),
    "viscous-drag": Kind({"viscous": 0.3}, ("viscous-drag", "quadratic-drag"),
                         measure=("viscous-drag.coefficient", 0.3 * LBF_IN)),
    "quadratic-drag": Kind({"quadratic": 0.15}, ("quadratic-drag", "viscous-drag")),
    "imbalance": Kind({"heavy_cos": 0.0, "heavy_sin": 2.0}, IMBALANCE, turned=True),
    "added-inertia": Kind({"inertia": 0.06}, ("added-inertia",),
                          measure=("added-inertia.inertia_change", 0.06 * LBF_IN)),
    "sensor-gain": Kind({"gain": 0.04}, ("sensor gain",), signed=True,
                        measure=("sensor gain.gain", 0.04)),
    "sensor-offset": Kind({"zero": 3.0}, ("sensor offset",), signed=True,
                          measure=("sensor offset.offset", 3.0 * LBF_IN)),
    "sensor-lag": Kind({"slow": 0.01}, ("sensor lag",), measure=("sensor lag.lag", 0.01)),
    "presliding-springs": Kind({"give": 0.012}, PRESLIDING),
    "backlash": Kind({"backlash": 0.01}, ("backlash",), measure=("backlash.gap", 0.01)),
    "rate-breakaway": Kind({"by_slope": 0.08}, ("rate-breakaway",)),
    "motor-gain": Kind({"motor_gain": 0.04}, ("motor sensor gain",), signed=True,
                       measure=("motor sensor gain.gain", 0.04)),
    "motor-offset": Kind({"motor_zero": 3.0}, ("motor sensor offset",), signed=True,
                         measure=("motor sensor offset.offset", 3.0 * LBF_IN)),
    "press-power": Kind({"power": 0.06}, ("press-power",), signed=True),
    # No effect: what was declared is wrong.
    "torque-scale": Kind({"slip": 0.3, "level": 0.3}, ("torque-scale",), signed=True,
                         declared=True),
    "breakaway-scale": Kind({"level": 0.3}, ("breakaway-scale",), declared=True),
    "time-constant": Kind({"lag": 0.1}, ("time-constant",), declared=True),
    # In nobody's list.
    "hidden-state": Kind({"hidden": 0.025, "wander": 0.02},
                         depends=("time", "run", "distance", "heat"), by_run=("wander_phase",)),
    "same-way-level": Kind({"same_way": 0.10}, depends=("level", "rest", "direction", "same_way")),
    "squeal": Kind({"squeal": 0.20}, depends=("breakaway", "displacement_since_reversal"),
                   shape=("squeal_frequency",)),
    "poles-by-command": Kind({"poles": 0.03}, depends=("position",)),
    "inertia-of-friction": Kind({"inertia_of_friction": 0.08}, depends=("acceleration",)),
    "squeeze-film": Kind({"squeeze": 0.15}, depends=("excitation_rate", "drive")),
}  # fmt: skip


def declared_departures(rng: np.random.Generator) -> dict[str, float]:
    """What the declared values are off by: within the tolerances that the data state."""
    return {
        "slip": 1 + rng.uniform(-0.03, 0.03),
        "level": 1 + rng.uniform(-0.03, 0.03),
        "slope": 1 + rng.uniform(-0.12, 0.12),
        "lag": 0.07 * (1 + rng.uniform(-0.15, 0.15)),
    }


def hidden_fields(effects: Mapping[str, float], rng: np.random.Generator) -> dict[str, float]:
    """Fields of `Numbers` that differ from what is declared; draws depend on the order of names."""
    found: dict[str, float] = {}
    neutral = Numbers()
    for name, strength in effects.items():
        kind = KINDS[name]
        sign = rng.choice((-1.0, 1.0)) if kind.signed else 1.0
        sizes = {k: sign * strength * v for k, v in kind.size.items()}
        if kind.turned:
            fields = [k for k in sizes if k.endswith(("cos", "sin"))]
            for cosine, sine in zip(fields[::2], fields[1::2], strict=True):
                angle, size = rng.uniform(0, 2 * np.pi), sizes[sine]
                sizes[cosine], sizes[sine] = size * np.cos(angle), size * np.sin(angle)
        for k, v in sizes.items():
            base = getattr(neutral, k)
            found[k] = found.get(k, base) + float(v)
        for k in kind.shape:
            found[k] = getattr(neutral, k) * float(rng.uniform(0.8, 1.25))
    return found
