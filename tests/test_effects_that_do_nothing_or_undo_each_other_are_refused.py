"""Effects on nothing, without their functions, or of which one makes another void: in words."""

from dataclasses import dataclass, replace

import pytest
from effect_rig import rig

from simpter_hybrid.checks.validation import validate
from simpter_hybrid.derive import derive_text
from simpter_hybrid.device import Device
from simpter_hybrid.effect import Effect
from simpter_hybrid.effects.coil_supply import CoilSupply
from simpter_hybrid.effects.command_scale import CommandScale
from simpter_hybrid.effects.cross_coupling import CrossCoupling
from simpter_hybrid.effects.dahl import Dahl
from simpter_hybrid.effects.lugre import LuGre
from simpter_hybrid.effects.pull_in import PullIn
from simpter_hybrid.effects.slew_limit import SlewLimit
from simpter_hybrid.effects.stribeck import Stribeck
from simpter_hybrid.effects.viscous_drag import ViscousDrag
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.problems import InvalidInput


@dataclass(frozen=True)
class Nothing(Effect):
    """Changes no port."""


@dataclass(frozen=True)
class Unfinished(Effect):
    """A state without a rate."""

    states = ("z",)

    @staticmethod
    def slip_torque(torque, z):
        return torque + z


@pytest.mark.parametrize(
    ("effects", "path", "what"),
    [
        ((Stribeck(clutch=3),), "effects.0.clutch", "no such clutch"),
        ((PullIn(),), "effects.0.clutch", "no such clutch"),
        ((ViscousDrag(coordinate=1),), "effects.0.coordinate", "no such coordinate"),
        ((Nothing(clutch=0),), "effects.0", "it changes nothing"),
        ((Unfinished(clutch=0),), "effects.0", "z_rate is missing"),
        ((Dahl(clutch=0), LuGre(clutch=0)), "effects.1", "it replaces the bristle torque"),
        (
            (SlewLimit(clutch=0, slowness=0.1), CoilSupply(clutch=0)), "effects.1",
            "it replaces the excitation rate that SlewLimit made",
        ),
    ],
    ids=lambda x: x if isinstance(x, str) else "",
)  # fmt: skip
def test_it_is_said_which_effect_and_why(effects, path, what):
    with pytest.raises(InvalidInput) as found:
        validate(rig(effects))
    (problem,) = found.value.problems
    assert problem.path == path
    assert problem.what.startswith(what)


def test_effects_that_use_what_came_before_them_go_together():
    run = rig((CoilSupply(clutch=0), SlewLimit(clutch=0, slowness=0.1), PullIn(clutch=0)))
    validate(run)
    assert simulate(run).status == "finished"


@pytest.mark.parametrize("kind", ["dahl", "pull-in", "stribeck"])
def test_an_effect_in_a_file_names_its_clutch_and_nothing_else(kind):
    text = resolve(rig().replace(loads=())).text
    with pytest.raises(InvalidInput, match=r"effects\.0\.clutch: missing"):
        parse(text + f'[[effects]]\nkind = "{kind}"\n')
    with pytest.raises(InvalidInput, match=r"effects\.0\.coordinate: an effect on a clutch"):
        parse(text + f'[[effects]]\nkind = "{kind}"\nclutch = 1\ncoordinate = "rotor"\n')


def test_a_clutch_is_no_neighbour_of_its_own():
    with pytest.raises(ValueError, match="no neighbour of its own"):
        CrossCoupling(clutch=0, gain=0.1, neighbour=0.0)


def test_n_and_m_are_no_names_of_parameters():
    with pytest.raises(TypeError, match="m cannot be the name of a parameter"):
        type("Mine", (Device,), {"__annotations__": {"m": float}})
    import sympy as sp

    angle, rate, m = sp.symbols("angle rate m")
    kinetic, parameters = m * rate**2 / 2, {m: ("inertia", 1.0)}
    with pytest.raises(ValueError, match="'m' is a name that every device has for something else"):
        derive_text("Mine", [angle], [rate], kinetic, {"joint": angle}, parameters)


@pytest.mark.parametrize("effect", [CommandScale(clutch=0, gain=-0.5), SlewLimit(clutch=0)])
def test_where_a_clutch_has_no_lag_nothing_is_before_it(effect):
    late = rig((effect,))
    validate(late)
    with pytest.raises(InvalidInput, match=r"clutch 1 has no lag.*a time_constant above 0"):
        validate(late.replace(clutches=(replace(late.clutches[0], time_constant=0.0),)))
