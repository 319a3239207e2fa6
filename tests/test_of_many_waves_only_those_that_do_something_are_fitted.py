"""Three to twelve waves a turn all hold what one wave does; further numbers tell them apart."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from toy_rig import SCALE, ToyRig, toy_replay

from simpter_hybrid.identification.fitting.alike_forms import beyond_simpler
from simpter_hybrid.identification.fitting.fitted_model import Split, refitted
from simpter_hybrid.identification.fitting.memory import Memory
from simpter_hybrid.identification.fitting.predictor import Candidate, Parameter
from simpter_hybrid.identification.fitting.search import try_candidates
from simpter_hybrid.identification.tracing.further import further_forms

SECOND = 0.05


@dataclass(frozen=True)
class Turning(ToyRig):
    """A torque with waves of a turn; numbers are called ``waves-3.once`` and ``waves-3.often``."""

    parameters: tuple[Parameter, ...] = (SCALE,)

    def extended(self, candidate: Candidate) -> "Turning":
        return Turning((*self.parameters, *candidate.parameters))

    def predict(self, values, replays):
        return {"torque": [_torque(values, r.inputs["u"], r.time) for r in replays]}


def _torque(values, drive, angle):
    found = values["scale"] * drive
    for name, size in values.items():
        form, _, which = name.partition(".")
        if which:
            often = int(form.removeprefix("waves-"))
            found = found + size * np.sin((often if which == "often" else 1) * angle)
    return found


def _waves(number: int, *names: str) -> Candidate:
    form = f"waves-{number}"
    numbers = tuple(Parameter(f"{form}.{name}", 0.0, -5.0, 5.0, 0.05) for name in names)
    starts = ((0.0,) * len(names),)
    return Candidate(form, numbers, starts, "waves", "load", ("load:position",))


ONCE, TWICE = _waves(1, "once"), replace(_waves(2, "once", "often"), simpler="waves-1")
MORE = [replace(_waves(n, "once", "often"), simpler="waves-1", further=True) for n in range(3, 13)]


def _kept(number: int, forms, second=SECOND):
    def run(seed):
        replay = toy_replay("run", seed)
        seen = replay.observed["torque"]
        hidden = {"scale": 0.0, f"waves-{number}.once": 0.3, f"waves-{number}.often": second}
        values = seen.values + _torque(hidden, 0.0, replay.time)
        return replace(replay, observed={"torque": replace(seen, values=values)})

    split = Split([run(1), run(2)], [run(3)], [run(4)])
    base = refitted(Turning(), split)
    trials = try_candidates(base, [ONCE, TWICE], split, floor=1.0)
    ended = {t.candidate.name: t for t in trials}
    begun = further_forms(trials[0], trials, forms)
    return [c.name for c in beyond_simpler(begun, ended, base, split, Memory())]


@pytest.mark.parametrize("number", [3, 7, 12])
def test_waves_that_are_there_are_fitted_alone(number):
    assert _kept(number, MORE) == [f"waves-{number}"]


def test_nothing_is_fitted_beside_two_waves_that_do_it_all():
    assert _kept(2, MORE) == []


def test_nothing_is_fitted_where_one_wave_leaves_noise():
    assert _kept(2, MORE, second=0.0) == []


def test_of_few_forms_all_are_fitted():
    assert _kept(2, MORE[:3]) == ["waves-3", "waves-4", "waves-5"]
