from dataclasses import replace

from toy_rig import toy_replay

from simpter_hybrid.identification.fitting.replay import measured_like


def test_each_channel_by_the_first_run_that_has_it():
    plan, first, second = (toy_replay(name, 1) for name in ("plan", "first", "second"))
    (torque,) = first.observed.values()
    first = replace(first, observed={"torque": replace(torque, sd=0.2, own=3.0)})
    second = replace(second, observed={c: replace(torque, sd=0.7) for c in ("torque", "speed")})
    plan = replace(plan, observed={c: torque for c in ("torque", "speed", "position")})
    seen = measured_like(plan, [first, second]).observed
    assert {c: (o.sd, o.own) for c, o in seen.items()} == {
        "torque": (0.2, 3.0),
        "speed": (0.7, torque.own),
        "position": (torque.sd, torque.own),
    }
