"""``[clutch]`` gives what all clutches have, ``[[clutches]]`` what one of them has instead."""

import pytest

from simpter_hybrid.clutch import Clutch
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.laws import LinearTorque
from simpter_hybrid.problems import InvalidInput

HEAD = """
[run]
t_end = "1 s"
[device]
kind = "shaft-pair"
driving = "1 kg*m^2"
driven = "2 kg*m^2"
[start]
coordinates = ["0 rad", "0 rad"]
[clutch]
delay = "0 s"
torque = { kind = "linear", rated = "10 N*m" }
"""


def test_one_clutch_may_differ():
    second = '[[clutches]]\ndelay = "20 ms"\ntorque = { rated = "5 N*m" }\n'
    scenario = parse(HEAD + "[[clutches]]\n" + second)
    assert scenario.clutches == (
        Clutch(delay=0.0, torque=LinearTorque(rated=10.0)),
        Clutch(delay=0.02, torque=LinearTorque(rated=5.0)),
    )


def test_a_law_of_another_kind_takes_nothing_over():
    law = '[[clutches]]\ntorque = { kind = "coulomb-viscous", coulomb = "3 N*m" }\n'
    first, second = parse(HEAD + "[[clutches]]\n" + law).clutches
    assert first.torque == LinearTorque(rated=10.0)
    assert second.torque.coulomb == 3.0
    assert second.delay == 0.0


def test_what_is_wrong_in_common_is_told_at_its_line():
    text = HEAD.replace('delay = "0 s"', 'delay = "0 m"')
    with pytest.raises(InvalidInput) as caught:
        parse(text + '[[clutches]]\n[[clutches]]\ndelay = "1 ms"\n')
    (problem,) = caught.value.problems
    line = text.splitlines().index('delay = "0 m"') + 1
    assert problem.where.endswith(f":{line}")
    assert problem.path == "clutches.0.delay"
