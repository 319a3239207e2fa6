"""The impedance controller on disturbed measurements (thesis 6.3): potentiometers and encoders.

The shipped line at 150 Hz, its controller fed by readings instead of the true state. Noise belongs
to its seed, so the table repeats itself; one seed shows no more than that the level matters.

    python benchmarks/noisy_measurements.py [SCENARIO]
"""

from __future__ import annotations

import sys

from simpter_hybrid.controllers.measurement import Measurement
from simpter_hybrid.engine import simulate
from simpter_hybrid.metrics import measures
from simpter_hybrid.scenario_file import load

#: Name, standard deviation and step of positions [rad], speeds from differences (1) or tachometers
#: (0), time constant of the filter on differenced speeds [s].
LEVELS = (
    ("true state", 0.0, 0.0, 0.0, 0.0),
    ("encoder, 16384 counts", 0.0, 3.835e-4, 1.0, 0.0),
    ("potentiometer", 4e-4, 5.75e-4, 1.0, 0.0),
    ("potentiometer, filtered 10 ms", 4e-4, 5.75e-4, 1.0, 0.01),
    ("potentiometer and tachometer", 4e-4, 5.75e-4, 0.0, 0.0),
    ("three times the noise", 1.2e-3, 5.75e-4, 1.0, 0.0),
)


def main() -> None:
    """Print the table."""
    name = sys.argv[1] if len(sys.argv) > 1 else "line-y24"
    base = load(name)
    rows = []
    for title, noise, resolution, differenced, low_pass in LEVELS:
        stage = Measurement(noise, resolution, 0.0, differenced, low_pass, 0.0, 1.0)
        run = simulate(base.replace(controllers=((stage, 1), *base.controllers)))
        found = {k: v for k, v in vars(measures(run)).items() if isinstance(v, float)}
        rows.append((title, run.status, len(run.events), found))
    names = list(rows[0][3])
    print("  ".join(["measurement".ljust(30), "status", "events", *names]))
    for title, status, events, found in rows:
        values = (f"{found.get(n, float('nan')):.5g}".rjust(len(n)) for n in names)
        print("  ".join([title.ljust(30), status, str(events).rjust(6), *values]))


if __name__ == "__main__":
    main()
