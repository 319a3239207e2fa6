"""Friction models of thesis 3.2.3.2 on one bench: stick drift, instants of events, cost, stiffness.

A rotor under a friction of 1 N m (breakaway 1.3 N m).  Drift: a load that swings about a bias and
never reaches breakaway; an exact model does not move (what rings without damping, as the bristles
do, shows up here too).  Events: a ramp up, down and reversed; the
instants at which the rotor sets out, stops and sets out again, by its speed passing 0.02 rad/s.
Stiffness: largest size of an eigenvalue of the linearised flow at rest [1/s].

    python benchmarks/friction_models.py [FOLDER]     table; friction-models.md and .png in FOLDER
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from simpter_hybrid import engine, regularised
from simpter_hybrid.clutch import Clutch
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.effect import Effect
from simpter_hybrid.effects.bristles import Bristles
from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.effects.lugre import LuGre
from simpter_hybrid.effects.reset_integrator import ResetIntegrator
from simpter_hybrid.karnopp.simulate import simulate as karnopp
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.loads.piecewise import TorqueOnClutch
from simpter_hybrid.regularised.smooth_friction import Smooth
from simpter_hybrid.running.segment import Run
from simpter_hybrid.scenario import Scenario

INERTIA, GIVE, BAND, PASSES = 0.1, 1e-3, 1e-3, 0.02
SWING = 0.4
DRIFT_TIME, RAMP_TIME = 5.0, 6.0


LEAD = """# The friction models of thesis 3.2.3.2 on one bench

    python benchmarks/friction_models.py docs

made this page (CPU times on a machine with other programs at work). A rotor of which a clutch takes
1 N m (breakaway 1.3 N m). Drift: a load that swings about a bias and never reaches breakaway, under
which an exact model does not move. Passings: a ramp up, down and reversed; the instants at which
the speed passes 0.02 rad/s. Stiffness: largest eigenvalue of the linearised flow at rest.

![Angle of a held rotor, and of one that breaks away, by seven friction models](friction-models.png)

"""
REST = """
The models with a spring (Dahl, LuGre, reset integrator, bristles) move before they break away and
ring afterwards, whence their further passings; how far is set by their stiffness, here chosen soft
enough to be seen. All four tend to exact stiction in proportion to their displacement, and below
breakaway they move by a share of it that can be written down
(`pytest tests/test_effects_of_friction_follow_closed_forms.py`).
"""


def scenario(points: tuple, t_end: float, effects: tuple[Effect, ...] = ()) -> Scenario:
    """The rotor under a torque that is straight between points."""
    law = LinearTorque(rated=10.0, ratio=1.3)
    clutch = Clutch(law, time_constant=0.0, delay=0.0, threshold=0.05)
    run = Scenario("bench", Testbed(INERTIA), (clutch,), (0.0,), (0.0,), t_end)
    return run.replace(
        loads=(TorqueOnClutch(points),), effects=effects, command=(1.0,), excitation=(1.0,)
    )


def swinging() -> tuple:
    """0.5 N m, and a triangle of 0.4 N m at 2 Hz about it."""
    corners = [(0.0, 0.0)]
    for k in range(int(4 * DRIFT_TIME)):
        corners.append((0.125 + 0.25 * k, 0.5 + SWING * (1 if k % 2 == 0 else -1)))
    return tuple(corners)


RAMP = ((0.0, 0.0), (2.0, 2.0), (6.0, -2.0))
MODELS: dict[str, tuple[Callable, tuple[Effect, ...]]] = {
    "exact": (engine.simulate, ()),
    "Karnopp": (lambda s: karnopp(s, band=BAND), ()),
    "tanh": (lambda s: regularised.simulate(s, width=BAND), ()),
    "Dahl": (engine.simulate, (Dahl(clutch=0, displacement=GIVE),)),
    "LuGre": (engine.simulate, (LuGre(clutch=0, displacement=GIVE, damping=0.01),)),
    "reset integrator": (
        engine.simulate,
        (ResetIntegrator(clutch=0, displacement=GIVE, damping=0.01),),
    ),
    "bristles": (engine.simulate, (Bristles(clutch=0, displacement=GIVE),)),
}


def passings(trajectory, grid: np.ndarray) -> list[float]:
    """Instants at which the speed's size passes 0.02 rad/s [s]."""
    speed = np.array([abs(trajectory.state(t, "left")[1]) for t in grid]) - PASSES
    at = np.flatnonzero(np.sign(speed[1:]) != np.sign(speed[:-1]))
    share = speed[at] / (speed[at] - speed[at + 1])
    return (grid[at] + share * (grid[at + 1] - grid[at])).tolist()


def stiffness(name: str) -> float:
    """Largest size of an eigenvalue of the flow at rest, by differences [1/s]; 0 if it sticks."""
    effects = MODELS[name][1]
    s = scenario(RAMP, 1.0, effects)
    if name == "tanh":
        smooth = Smooth(s, BAND)
        found = smooth.jacobian(0.0, np.array(smooth.y))[:2, :2]
        return float(abs(np.linalg.eigvals(found)).max())
    if not effects:
        return 0.0
    run = Run(s)
    run.sample(0)
    run.settle(0)
    y0 = np.array(run.y)
    h = 1e-9
    at = [0, 1, *range(3, 3 + len(s.text.a.states))]
    rows = [(run.right_hand_side(0.0, y0 + h * np.eye(len(y0))[k])
             - run.right_hand_side(0.0, y0)) / h for k in at]  # fmt: skip
    return float(abs(np.linalg.eigvals(np.array(rows).T[at])).max())


def measure(name: str) -> dict[str, float | str]:
    """A row of the table."""
    simulate, effects = MODELS[name]
    began = time.process_time()
    rest = simulate(scenario(swinging(), DRIFT_TIME, effects))
    ramp = simulate(scenario(RAMP, RAMP_TIME, effects))
    cost = time.process_time() - began
    if "failed" in (rest.status, ramp.status):
        return {"model": name, "note": rest.message + ramp.message}
    halves = [rest.state(t, "left")[0] for t in (1.0, DRIFT_TIME)]
    found = passings(ramp, np.linspace(0.0, RAMP_TIME, 12001))
    moved = {f"passing {k + 1} [s]": round(t, 5) for k, t in enumerate(found[:3])}
    return {
        "model": name, "drift [rad/s]": f"{(halves[1] - halves[0]) / (DRIFT_TIME - 1.0):.3g}",
        **moved, "passings": len(found), "steps": len(rest.step_t) + len(ramp.step_t),
        "CPU [s]": round(cost, 2), "stiffness [1/s]": f"{stiffness(name):.3g}",
    }  # fmt: skip


def picture(file: Path) -> None:
    """Angle under the swinging load, and at the first breakaway of the ramp."""
    from simpter_hybrid.plots.style import CLUTCH_COLOURS, figure, legend_beside_title, png, styled

    @styled
    def draw():
        made = figure(4.2, "Friction models")
        axes = made.subplots(1, 2)
        for name, colour in zip(MODELS, CLUTCH_COLOURS, strict=False):
            simulate, effects = MODELS[name]
            for ax, points, t_end in ((axes[0], swinging(), DRIFT_TIME), (axes[1], RAMP, 1.6)):
                run = simulate(scenario(points, t_end, effects))
                t = np.linspace(0.0, run.t_end, 800)
                angle = [1e3 * run.state(x, "left")[0] for x in t]
                # Below the others, whose lines it shares until it breaks away.
                wide = {"linewidth": 4.0, "alpha": 0.5} if name == "exact" else {"linewidth": 1.2}
                ax.plot(t, angle, color=colour, label=name, **wide)
        axes[0].set(xlabel="time / s", ylabel="angle / mrad", title="held: drift")
        axes[1].set(xlabel="time / s", title="ramp: breakaway", ylim=(-0.5, 8), xlim=(0.0, 1.6))
        legend_beside_title(made, axes[0].get_lines())
        return made

    file.write_bytes(png(draw()))


def main() -> None:
    """Print the table; write the page and its picture."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", nargs="?", type=Path, default=Path("."))
    folder = parser.parse_args().folder
    folder.mkdir(parents=True, exist_ok=True)
    rows = [measure(name) for name in MODELS]
    names = list(dict.fromkeys(key for row in rows for key in row))
    for row in [dict(zip(names, names, strict=True)), *rows]:
        print("  ".join(f"{row.get(n, '')!s:>16}" for n in names))
    lines = [f"| {' | '.join(str(row.get(n, '')) for n in names)} |" for row in rows]
    table = [f"| {' | '.join(names)} |", "|" + "---|" * len(names), *lines]
    page = LEAD + "\n".join(table) + "\n" + REST
    (folder / "friction-models.md").write_text(page, encoding="utf-8", newline="\n")
    picture(folder / "friction-models.png")


if __name__ == "__main__":
    main()
