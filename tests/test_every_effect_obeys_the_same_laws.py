"""Energy, exactness, nothing at size zero, the experiment that reveals it: for all effects."""

import dataclasses
from functools import lru_cache

import numpy as np
import pytest
from effect_rig import ALWAYS, BETWEEN, NOTHING, all_effects, attached, pair, rig

from simpter_hybrid.engine import simulate
from simpter_hybrid.measuring.energy import energy_balance
from simpter_hybrid.measuring.sampling import sample
from simpter_hybrid.reading.kinds import shipped

EFFECTS = all_effects()


@lru_cache
def plain():
    return simulate(rig())


@pytest.mark.parametrize("effect", EFFECTS, ids=lambda cls: cls.__name__)
def test_the_energy_budget_closes_and_a_stuck_clutch_does_not_slip(effect):
    run = simulate(rig([attached(effect)]))
    assert run.status == "finished", run.message
    times = np.linspace(0.0, run.t_end, 60)
    seen = sample(run, times)
    balance = energy_balance(run, seen)
    # Solver tolerance 1e-10 on each of some hundred steps.
    assert balance.relative < 1e-8
    assert (seen.slip[seen.mode == 0] == 0.0).all()
    # Bristles store energy and hand it back; a clutch with stiction never does.
    if "bristle_torque" not in effect().functions():
        assert balance.max_clutch_power <= 1e-12
    # It does something: else the rest says nothing.
    assert np.abs(run.end[:3] - plain().end[:3]).max() > 1e-9


@pytest.mark.parametrize(
    "effect", [c for c in EFFECTS if c.__name__ not in ALWAYS], ids=lambda cls: cls.__name__
)
def test_an_effect_of_size_zero_changes_nothing(effect):
    with_it, without = (rig(e) for e in ([attached(effect, 0.0)], []))
    assert with_it.switching() == without.switching()
    random = np.random.default_rng(5)
    for mode in (1, 0, -1, 2):
        speed, u = mode * random.uniform(0, 3) if mode in (1, -1) else 0.0, random.uniform(0, 8)
        found = []
        for scenario in (with_it, without):
            md = scenario.python_model()
            y, w = scenario.initial(lambda k: [0.0] * k, lambda k: [0] * k)
            y[0:3] = [0.7, speed, u]
            for k in range(len(scenario.text.a.states)):
                y[3 + k] = 0.3
            w.mode[0], w.gate[0], w.held[0] = mode, 0 if mode == 2 else 2, 1.3
            md.terms(
                0.4, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.M, w.C, w.c, w.f, w.Q, w.fr
            )
            dy = [0.0] * md.ny
            md.rates(0.4, y, md.p, md.rec, w.held, w.mode, w.gate, w.dmode, w.tau, w.C, w.s, dy)
            found.append([*w.M[:1], *w.f[:1], *w.fr[:5], dy[2]])
        # One rounding or two of a product with 1.
        np.testing.assert_allclose(found[0], found[1], rtol=1e-15, atol=0.0)


def test_the_same_run_gives_the_same_bytes():
    effects = [attached(cls) for cls in EFFECTS if cls.__name__ not in ALWAYS]
    effects.sort(key=lambda effect: type(effect).__name__ == "RotorLoad")  # it has to be the last
    first, second = (simulate(rig(effects, t_end=0.03)) for _ in range(2))
    assert first.status == "finished", first.message
    assert first.step_y.tobytes() == second.step_y.tobytes()
    assert first.end.tobytes() == second.end.tobytes()


@pytest.mark.parametrize("effect", shipped("effect").values(), ids=lambda cls: cls.__name__)
def test_an_effect_says_what_reveals_it_and_how_large_it_is(effect):
    assert len(effect.reveals) > 20
    assert effect.reveals.endswith(".")
    fields = {f.name: f for f in dataclasses.fields(effect)}
    for name in effect.sizes:
        assert fields[name].metadata["typical"] > 0.0
        assert fields[name].default == 0.0 or len(effect.sizes) > 1


@pytest.mark.parametrize("name", BETWEEN)
def test_an_effect_on_a_pair_keeps_the_energy_budget(name):
    run, without = simulate(pair([BETWEEN[name]])), simulate(pair())
    assert run.status == "finished", run.message
    seen = sample(run, np.linspace(0.0, run.t_end, 60))
    balance = energy_balance(run, seen)
    # Solver tolerance 1e-10 on each of some hundred steps.
    assert balance.relative < 1e-8
    assert balance.max_clutch_power <= 1e-12
    assert (seen.slip[seen.mode == 0] == 0.0).all()
    assert np.abs(run.end[:4] - without.end[:4]).max() > 1e-9
    effect = BETWEEN[name]
    nothing = NOTHING.get(name) or dict.fromkeys(type(effect).sizes, 0.0)
    none = simulate(pair([dataclasses.replace(effect, **nothing)]))
    if effect.states:  # one more state in the norm of an error: other steps
        assert none.end[:6] == pytest.approx(without.end[:6], abs=1e-8)
        return
    assert none.end.tobytes() == without.end.tobytes()
