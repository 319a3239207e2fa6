"""6.3.1, 6.3.2: controllers on noisy and quantised measurements, at several levels, many seeds."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from ..controllers.measurement import Measurement
from ..reproduce.standard import CONTROLLERS
from ..rigs.line import line
from ..scenario import Scenario
from .batch import Measured, measured
from .study import Study, Table

#: A turn [rad], a converter's step of 12 bits over 270 degrees, and a potentiometer's noise [rad].
TURN = 2.0 * math.pi
BITS, NOISE = 0.75 * TURN / 4096.0, 4e-4


@dataclass(frozen=True)
class Sensor:
    """Noise, step [rad]; speeds from differences or not; their filter [s]; their noise [rad/s]."""

    noise: float
    step: float
    differenced: bool = True
    filter: float = 0.0
    speed_noise: float = 0.0

    def stage(self, seed: int) -> Measurement:
        """The stage before the controllers."""
        kind = 1.0 if self.differenced else 0.0
        return Measurement(
            self.noise, self.step, 0.0, kind, self.filter, self.speed_noise, float(seed)
        )


TRUE, POT = "true state", "potentiometer"
SENSORS = {
    TRUE: Sensor(0.0, 0.0, False),
    "encoder, 65536 counts": Sensor(0.0, TURN / 65536.0),
    "encoder, 16384 counts": Sensor(0.0, TURN / 16384.0),
    "encoder, 4096 counts": Sensor(0.0, TURN / 4096.0),
    "potentiometer, noise / 4": Sensor(0.25 * NOISE, BITS),
    POT: Sensor(NOISE, BITS),
    "potentiometer, noise x 4": Sensor(4.0 * NOISE, BITS),
    "potentiometer, 10 ms filter": Sensor(NOISE, BITS, filter=0.01),
    "potentiometer, 30 ms filter": Sensor(NOISE, BITS, filter=0.03),
    "potentiometer and tachometer": Sensor(NOISE, BITS, False, 0.0, 5e-3),
}


def disturbed(controller: str, sensor: Sensor, seed: int) -> Scenario:
    """The standard run of a controller that sees readings."""
    scenario = line(*CONTROLLERS[controller])
    stages = ((sensor.stage(seed), 1), *scenario.controllers)
    return scenario.replace(controllers=stages, t_end=6.0)


def scattered(values: np.ndarray) -> str:
    """Median, and tenth and ninetieth percentile."""
    low, middle, high = np.quantile(values, [0.1, 0.5, 0.9])
    if high - low < 1e-12:
        return f"{middle:.3g}"
    return f"{middle:.3g} ({low:.3g}-{high:.3g})"


def measurements(size: int = 24) -> Study:
    """Every sensor and controller with ``size`` seeds of the noise."""
    keys = [(c, name) for c in CONTROLLERS for name in SENSORS]
    runs = [disturbed(c, SENSORS[name], seed) for c, name in keys for seed in range(size)]
    every = measured(runs)
    found = {key: every.part(slice(k * size, (k + 1) * size)) for k, key in enumerate(keys)}
    rows = tuple(
        (c, name, scattered(m.error), scattered(m.jerk), scattered(m.stops),
         f"{m.reached.sum()} of {size}")
        for (c, name), m in found.items()
    )  # fmt: skip
    return Study(
        "Controllers on noisy and quantised measurements: what do they lose?",
        "thesis, sections 6.3.1 (different levels of noise) and 6.3.2 (encoders, tachometers)",
        f"Every run follows the line y = 24 in with the nominal inputs, {size} times for each "
        "sensor, each time with another seed of the noise. Positions are read at 150 Hz. Speeds "
        "are differences of these readings, filtered where the table says so, or come from a "
        f"tachometer (noise of 5 mrad/s). The potentiometer has {1e3 * NOISE:g} mrad of noise, and "
        f"its converter has 12 bits over 270 degrees ({1e3 * BITS:.2g} mrad a step); the thesis "
        "prints neither. The factors in the findings compare medians over the seeds.",
        (
            Table(
                "Median over the seeds (10th to 90th percentile)",
                ("controller", "measurement", "error / in", "jerk / in/s^3",
                 "stops and breakaways", "reached the end"),
                rows,
            ),
        ),
        sentences(found),
        {f"{c}, {name}": {"error": m.error.tolist(), "jerk": m.jerk.tolist()}
         for (c, name), m in found.items()},
        picture(found),
        "Dots: median over the seeds. Bars: 10th to 90th percentile. Dotted lines: with the "
        "true state.",
    )  # fmt: skip


def sentences(found: dict[tuple[str, str], Measured]) -> tuple[str, ...]:
    """What the medians say."""

    def times(controller: str, name: str, what: str, base: str = TRUE) -> str:
        one, other = (np.median(getattr(found[controller, n], what)) for n in (name, base))
        return f"{one / other:.2f} ({controller})"

    def all_of(name: str, what: str, base: str = TRUE) -> str:
        return ", ".join(times(c, name, what, base) for c in CONTROLLERS)

    fine, tacho = "encoder, 65536 counts", "potentiometer and tachometer"
    return (
        "Readings of a potentiometer, differentiated to get speeds, instead of the true state "
        f"multiply the error by {all_of(POT, 'error')}, and the jerk by {all_of(POT, 'jerk')}.",
        "An encoder of 65536 counts instead of the true state multiplies the error by "
        f"{all_of(fine, 'error')}, and the jerk by {all_of(fine, 'jerk')}.",
        "A filter of 30 ms on the potentiometer's speeds instead of none multiplies the error by "
        f"{all_of('potentiometer, 30 ms filter', 'error', POT)}, and the jerk by "
        f"{all_of('potentiometer, 30 ms filter', 'jerk', POT)}.",
        "Speeds from tachometers instead of differences of the potentiometer's readings multiply "
        f"the error by {all_of(tacho, 'error', POT)}, and the jerk by "
        f"{all_of(tacho, 'jerk', POT)}.",
    )


def picture(found: dict[tuple[str, str], Measured]):
    """Error and jerk of every sensor."""
    from matplotlib.lines import Line2D

    from ..plots.style import CLUTCH_COLOURS, INK, figure, legend_beside_title, plain_log, styled

    @styled
    def draw():
        made = figure(5.7, "Measurements that controllers see")
        names = list(SENSORS)
        axes = made.subplots(1, 2, sharey=True)
        for ax, what, unit in zip(axes, ("error", "jerk"), ("in", "in/s³"), strict=True):
            for k, controller in enumerate(CONTROLLERS):
                for j, name in enumerate(names):
                    values = getattr(found[controller, name], what)
                    low, middle, high = np.quantile(values, [0.1, 0.5, 0.9])
                    y, colour = j + 0.22 * (k - 1), CLUTCH_COLOURS[k]
                    ax.plot([low, high], [y, y], color=colour)
                    ax.plot([middle], [y], "o", color=colour, markersize=4)
                true = float(np.median(getattr(found[controller, TRUE], what)))
                ax.axvline(true, color=CLUTCH_COLOURS[k], linewidth=0.7, linestyle=":")
            ax.set(xscale="log", xlabel=f"{what} / {unit}")
            plain_log(ax.xaxis)
        axes[0].set_yticks(range(len(names)), names)
        axes[0].invert_yaxis()
        dot = {"marker": "o", "markersize": 4}
        handles = [
            Line2D([], [], color=colour, label=c, **dot)
            for c, colour in zip(CONTROLLERS, CLUTCH_COLOURS, strict=False)
        ]
        true = Line2D([], [], color=INK, linewidth=0.7, linestyle=":", label="with the true state")
        legend_beside_title(made, [*handles, true])
        return made

    return draw
