"""A viscous drag of an axis is its declared viscous friction, which the refit has already."""

from types import SimpleNamespace as Some

from axis_recordings import MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.identifiability_report import Sight
from simpter_hybrid.identification.reporting.sight_data import sight_data, unseen
from simpter_hybrid.identification.reporting.tables import sight_tables

REFITTED = """[[tolerances]]
name = "viscous friction"
parameters = ["clutch.1.torque.viscous"]
relative = 0.3
"""
PAIR = ("drive-lag", "drive-delay")
SIGHT = Sight({}, ("viscous-drag", "force-gain"), ((*PAIR, 1.0),), {PAIR: ()}, {}, {}, [])


def found(model):
    predictor = Some(declared=parse(model, "axis.toml"))
    library = tuple(
        Some(name=n, family=n, acts_on="load", listed=True, experiment="") for n in SIGHT.blind
    )
    corrected = Some(predictor=predictor, effects=())
    return Some(search=Some(corrected=corrected), candidates=library)


def test_it_is_left_out_of_what_the_runs_would_not_show_and_the_table_says_why():
    one = found(MODEL + REFITTED)
    assert unseen(one, SIGHT) == ["force-gain"]
    table = sight_tables(sight_data(SIGHT, one, {}))
    assert "force): force-gain. viscous-drag is the declared viscous friction itself" in table


def test_without_a_tolerance_of_its_own_it_is_one():
    both = REFITTED.replace('viscous"]', 'viscous", "clutch.1.torque.coulomb"]')
    for model in (MODEL, MODEL.rpartition("[[tolerances]]")[0] + both):
        assert unseen(found(model), SIGHT) == ["viscous-drag", "force-gain"]


def test_what_small_effects_would_be_confused_with_is_said_to_be_of_small_ones():
    table = sight_tables(sight_data(SIGHT, found(MODEL), {}))
    assert "<td>drive-lag and drive-delay</td><td>100 %, if small</td>" in table
