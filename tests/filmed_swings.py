"""A pendulum that is let go and filmed, by steps of its own."""

import numpy as np
from axis_recordings import MAP, written
from axis_recordings import MODEL as DRIVEN

from simpter_hybrid.files.scenario_file import parse

INERTIA, WEIGHT, COULOMB, VISCOUS, NOISE = 0.02, 0.5, 0.005, 0.001, 2e-3
STEP, ROW, LASTS = 1e-3, 0.02, 8.0
#: A tenth heavier than it is: over a whole run that turns oscillations upside down.
DECLARED = parse(
    (DRIVEN[: DRIVEN.index("[[loads]]")] + DRIVEN[DRIVEN.index("[[tolerances]]") :])
    .replace("0.2 N*m", "0.005 N*m").replace("0.02 N*m*s", "0.001 N*m*s")
    .replace("0.02 kg", "0.022 kg").replace("relative = 0.2", "relative = 0.5")
    + '[[tolerances]]\nname = "inertia"\nparameters = ["device.inertia"]\nrelative = 0.1\n'
)  # fmt: skip
LET_ALONE = "driven = false\n" + MAP.partition("[channels.torque]")[0]


def swung(first, drag, force):
    """Angles (samples,) by steps of Heun; friction stops it where it can.

    `drag` times the square of speed, and a `force` over the angle, act beside what is declared.
    """

    def slowed(angle, speed):
        dry = COULOMB * np.sign(speed) + VISCOUS * speed + drag * speed * abs(speed)
        return (force(angle) - WEIGHT * np.sin(angle) - dry) / INERTIA

    angle, speed, angles = first, 0.0, []
    for _ in range(round(LASTS / STEP)):
        angles.append(angle)
        a = slowed(angle, speed)
        b = slowed(angle + STEP * speed, speed + STEP * a)
        held = abs(WEIGHT * np.sin(angle) - force(angle)) < COULOMB
        after = speed + 0.5 * STEP * (a + b)
        angle += 0.5 * STEP * (speed + after)
        speed = 0.0 if held and after * speed <= 0.0 else after
    return np.array(angles)[:: round(ROW / STEP)]


def filmed(folder, drag=0.0, force=lambda angle: 0.0, more=()):
    """Swings from four angles, of which the first fits, and from `more`, which fit as well."""
    described = LET_ALONE
    if more:
        fit = ["take 0", *(f"take {4 + k}" for k in range(len(more)))]
        described = LET_ALONE.replace('["take 0"]', str(fit).replace("'", '"'))
    generator, rows = np.random.default_rng(5), ["take,ms,angle"]
    for run, first in enumerate((1.0, -0.5, 0.8, -1.2, *more)):
        angle = swung(first, drag, force)
        seen = angle + NOISE * generator.standard_normal(angle.size)
        rows += [f"{run},{1e3 * ROW * k:.0f},{-np.degrees(q):.5f}" for k, q in enumerate(seen)]
    return written(folder, rows, described)
