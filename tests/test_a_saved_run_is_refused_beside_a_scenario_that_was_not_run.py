"""What a run depends on is compared, not the parameters alone; earlier runs stay readable."""

import io
import json
import zipfile

import numpy as np
import pytest
from sampled_runs import baseline

from simpter_hybrid.files.same_scenario import identity
from simpter_hybrid.files.storage import ABOUT, StoredRunError, load, save


@pytest.fixture(scope="module")
def saved(tmp_path_factory):
    return save(baseline(), tmp_path_factory.mktemp("a") / "run")


def earlier(directory):
    """The run as it was saved before its scenario was told."""
    file = directory / "trajectory.npz"
    out = io.BytesIO()
    with zipfile.ZipFile(file) as old, zipfile.ZipFile(out, "w") as new:
        for name in old.namelist():
            data = old.read(name)
            if name == ABOUT:
                data = json.dumps({k: v for k, v in json.loads(data).items() if k != "scenario"})
            new.writestr(name, data)
    file.write_bytes(out.getvalue())


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("q", (1.0, 1.0)), ("qd", (0.1, 0.0)), ("t_end", 99.0), ("period", 0.1),
        ("method", "RK45"), ("command", (9.0,) * 4), ("rec", (1.0,)),
    ],
)  # fmt: skip
def test_the_change_is_named(saved, name, value):
    other = baseline().scenario.replace(**{name: value})
    with pytest.raises(StoredRunError, match=name):
        load(saved, other)


def test_an_earlier_run_is_judged_by_what_it_shows(tmp_path):
    directory, scenario = save(baseline(), tmp_path / "run"), baseline().scenario
    earlier(directory)
    assert load(directory, scenario).t_end == baseline().t_end
    for changes in ({"q": (1.0, 1.0)}, {"t_end": 0.5 * baseline().t_end}):
        with pytest.raises(StoredRunError, match=next(iter(changes))):
            load(directory, scenario.replace(**changes))


def test_a_start_given_as_an_array_is_told_like_any_other():
    scenario = baseline().scenario
    as_array = scenario.replace(q=np.array(scenario.q), qd=np.array(scenario.qd))
    assert identity(as_array) == identity(scenario)
