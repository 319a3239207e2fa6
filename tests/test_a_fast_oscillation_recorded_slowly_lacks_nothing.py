"""A mass on a spring, let go, with dry friction: 36 rows a swing, and nothing missing.

A polynomial through nearly half a swing cuts its top, and where the trace of force was set anew
from it the spring seemed wrong in proportion to the place.
"""

import numpy as np
from axis_recordings import written

from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.scenario_file import parse

MASS, SPRING, FRICTION = 0.012, 0.92, 0.012
STEP, NOISE = 0.02, 0.002
#: Where each run begins [m].
FROM = (1.9, -1.6, 1.2, -2.0, 1.0, 1.5, -1.3, 1.75)
SETS = "AAAABBCC"
MODEL = f"""
[run]
t_end = "9 s"
[start]
coordinates = ["0 m"]
[device]
kind = "linear-axis"
mass = "{MASS} kg"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = {{ kind = "coulomb-viscous", coulomb = "{FRICTION} N", viscous = "0 N*s/m" }}
[[effects]]
kind = "spring-force"
coordinate = "slide"
stiffness = "{SPRING} N/m"
rest = "0 m"
[[tolerances]]
name = "spring"
parameters = ["effect.1.SpringForce.stiffness"]
relative = 0.05
[[tolerances]]
name = "friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.3
"""
MAP = """
driven = false
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["run"]
experiment = ["run"]
group = ["set"]
[split]
fit = ["set A"]
select = ["set B"]
report = ["set C"]
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "measured"
may_rest = true
"""


def swings(start, times):
    """Half swings about where friction and spring balance, until it stays (rows,)."""
    way, half = FRICTION / SPRING, np.pi / np.sqrt(SPRING / MASS)
    number = (times / half).astype(int)
    from_ = np.abs(start) - 2 * way * number
    moves = from_ > way
    last = max(0.0, np.abs(start) - 2 * way * np.ceil((np.abs(start) - way) / (2 * way)))
    phase = times / half - number
    course = (-1.0) ** number * (way + (from_ - way) * np.cos(np.pi * phase))
    rest = (-1.0) ** np.argmin(moves) * last if not moves.all() else 0.0
    return np.sign(start) * np.where(moves, course, rest)


def test_no_force_goes_along_with_the_place(tmp_path):
    draw = np.random.default_rng(5)
    rows = ["run,set,s,x"]
    for run, (start, group) in enumerate(zip(FROM, SETS, strict=True)):
        times = STEP * np.arange(400)
        seen = swings(start, times) + draw.normal(0.0, NOISE, times.size)
        rows += [f"{run},{group},{t:.3f},{x:.5f}" for t, x in zip(times, seen, strict=True)]
    recording = as_axis(written(tmp_path, rows, MAP))
    bench = bench_of(recording, parse(MODEL), groups_of(recording))
    replays = bench.parts["fit"]
    true = {p.name: p.value for p in bench.predictor.parameters}
    (traces,) = bench.tracer(replays)(bench.predictor, true, replays).values()
    place = np.concatenate([trace.coordinates["position"] for trace in traces])
    force = np.concatenate([trace.residual for trace in traces])
    # A hundredth of the spring's before; noise of 2 mm, over half a second, leaves a thousandth.
    assert abs(np.polyfit(place, force, 1)[0]) < 0.002 * SPRING
