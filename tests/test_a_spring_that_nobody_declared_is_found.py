"""A model without it stays where it is let go, and no small stiffness moves it from there."""

import pytest
from sprung_mass import MODEL, SPRING, recorded

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.axis.sizes import swung
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.groups import groups_of

SPRUNG = MODEL[MODEL.index("[[effects]]") : MODEL.index("[[tolerances]]")]
TOLERATED = MODEL[MODEL.index("[[tolerances]]") :].partition('[[tolerances]]\nname = "friction')[0]
FORGOTTEN = parse(MODEL.replace(SPRUNG, "").replace(TOLERATED, ""))


@pytest.mark.slow
def test_it_is_named_with_its_stiffness(tmp_path):
    recording = recorded(tmp_path)
    tried = bench_of(recording, FORGOTTEN, groups_of(recording)).candidates
    tried = [c for c in tried if c.name in ("spring-force", "bias-force", "viscous-drag")]
    found = diagnose(recording, FORGOTTEN, tried)
    done = found.search
    assert found.cut_short == 0.0
    assert [effect.name for effect in done.corrected.effects] == ["spring-force"]
    # The mass is known as declared; a period of 0.72 s over 8 s by rows of 2 mm noise: to 1e-4.
    assert done.corrected.values["spring-force.stiffness"] == pytest.approx(SPRING, rel=1e-3)
    assert done.corrected.select_error < 1.1 * done.floor


def test_where_one_is_declared_no_other_is_begun_at(tmp_path):
    recording = recorded(tmp_path)
    replays = bench_of(recording, FORGOTTEN, groups_of(recording)).parts["fit"]
    ((stiffness, rest),) = swung(FORGOTTEN, replays)
    assert stiffness == pytest.approx(SPRING, rel=0.1)  # a parabola over half a swing cuts its top
    assert rest == pytest.approx(0.0, abs=0.05)
    assert swung(parse(MODEL), replays) == ()
