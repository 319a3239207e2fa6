"""A dynamometer logs its speed, not its angle: it is what moves the axis, not what is compared."""

import numpy as np
import pytest
from moved_axis import DRIVEN, MAP, model

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.recorded import as_axis
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.fits import check_fits
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

MASS, COULOMB, VISCOUS = 2.0, 3.0, 10.0
FRICTION = 'coulomb = "3 N", viscous = "10 N*s/m"'
SPRING = """
[[effects]]
kind = "spring-force"
coordinate = "slide"
stiffness = "20 N/m"
rest = "0 m"
"""


def bench(folder, more="", role="measured"):
    generator, rows = np.random.default_rng(2), ["run,t,v,F"]
    for run in range(3):
        for t in np.arange(0.0, 5.0, 0.01):
            at = (2.0 + run) * t
            v, a = 0.1 * np.cos(at), -0.1 * (2.0 + run) * np.sin(at)
            force = MASS * a + COULOMB * np.sign(v) + VISCOUS * v + 0.05 * generator.normal()
            rows.append(f"{run},{t:.2f},{v:.6f},{force:.4f}")
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    speed = MAP.replace("channels.position", "channels.speed").replace('"x"', '"v"')
    speed = speed.replace('unit = "m"', 'unit = "m/s"').replace('"measured"', f'"{role}"')
    (folder / "map.toml").write_text(speed, encoding="utf-8")
    recording = as_axis(load_recording(folder / "data.csv", folder / "map.toml"))
    declared = parse(model(MASS, FRICTION) + DRIVEN + more)
    check_fits(recording, declared)
    return bench_of(recording, declared, groups_of(recording))


def test_its_force_is_that_of_the_friction_it_met(tmp_path):
    made = bench(tmp_path)
    run = made.parts["fit"][0]
    values = {p.name: p.value for p in made.predictor.parameters}
    told = made.predictor.predict(values, [run])["force"][0]
    seen = run.observed["force"]
    left = (seen.values - told)[seen.keep]
    assert np.sqrt(np.mean(left**2)) == pytest.approx(0.05, rel=0.15)  # some 500 samples
    assert not any("nothing uses" in remark.what for remark in made.remarks)


def test_what_depends_on_the_place_is_not_tried(tmp_path):
    made = bench(tmp_path)
    names = {c.name for c in made.candidates}
    assert "stribeck" in names
    values = {p.name: p.value for p in made.predictor.parameters}
    (trace,) = made.tracer(made.parts["fit"])(made.predictor, values, made.parts["fit"][:1])[
        "force"
    ]
    assert "position" not in trace.coordinates
    assert "displacement_since_reversal" in trace.coordinates
    assert not names & {"spring-force", "position-friction-wave", "ripple-force-wave"}


def test_a_model_that_depends_on_the_place_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match="depends on the position, which was not logged"):
        bench(tmp_path, SPRING)


def test_a_force_that_is_not_compared_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"channels\.force\.role"):
        bench(tmp_path, role="input")
