"""Mistakes in a class given with ``--also`` are told before thousands of runs ask it."""

from dataclasses import dataclass

import pytest
from axis_recordings import declared_axis, recorded_axis
from sticky_spot import StickySpot

from simpter_hybrid.effect import Effect
from simpter_hybrid.identification.axis.candidates import axis_candidates
from simpter_hybrid.identification.axis.rig import AxisRig
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.benches import as_recorded, bench_of
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.rigs.own_effect import own_candidates
from simpter_hybrid.identification.rigs.own_effect_check import check_own
from simpter_hybrid.identification.rigs.scenario_predictor import ScenarioPredictor
from simpter_hybrid.part import parameter
from simpter_hybrid.problems import InvalidInput

LIBRARY = axis_candidates(AxisSizes(1.0, 0.2, 1.0, 4.0, 0.02, turning=True))


class Misspelt(StickySpot):
    sizes = ("rice",)


class Nowhere(StickySpot):
    shows_along = ("slipvelocity",)


class Foreign(StickySpot):
    family = "positions"


class Undecorated(Effect):
    acts_on = "friction"
    rise: float = parameter("dimensionless", 0.0, typical=0.1)

    @staticmethod
    def slip_torque(torque, rise):
        return torque * (1.0 + rise)


@dataclass(frozen=True)
class Outside(StickySpot):
    width: float = parameter("coordinate", -0.1, above=0.0)


@dataclass(frozen=True)
class NotNeutral(StickySpot):
    @staticmethod
    def slip_torque(torque, rise):
        return torque * (1.3 + rise)


@dataclass(frozen=True)
class Infinite(StickySpot):
    @staticmethod
    def slip_torque(torque, speed, rise):
        return torque * (1.0 + rise / (speed * 0.0))


def _made(cls):
    return own_candidates([cls], LIBRARY, ScenarioPredictor(declared_axis(), AxisRig()))


@pytest.mark.parametrize(
    ("cls", "what"),
    [
        (Misspelt, "nothing that is fitted"),
        (Nowhere, "no such coordinate"),
        (Foreign, "misspelt?"),
        (Undecorated, "no dataclass"),
        (Outside, "out of bounds"),
    ],
)
def test_what_a_class_says_wrongly_is_told(cls, what):
    with pytest.raises(InvalidInput) as error:
        _made(cls)
    assert what in [p.what for p in error.value.problems]


@pytest.mark.parametrize(
    ("cls", "what"),
    [
        (NotNeutral, "it acts where they are 0"),
        (Infinite, "cannot be simulated"),
        (StickySpot, None),
    ],
)
def test_a_law_is_simulated_before_it_is_fitted(tmp_path, cls, what):
    recording = as_recorded(recorded_axis(tmp_path, []))
    bench = bench_of(recording, declared_axis(), groups_of(recording))
    values = {p.name: p.value for p in bench.predictor.parameters}
    asked = _made(cls), bench.predictor, values, bench.parts["fit"][:1]
    if what is None:
        check_own(*asked)
        return
    with pytest.raises(InvalidInput) as error:
        check_own(*asked)
    assert [p.what for p in error.value.problems] == [what]
