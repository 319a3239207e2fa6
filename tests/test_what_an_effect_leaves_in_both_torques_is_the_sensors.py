"""A neighbour that reaches the torque's sensor was named as one that changes the command."""

from types import SimpleNamespace

import pytest

from simpter_hybrid.identification.reporting.sentences import or_sensor_sentence

BOTH = ("load:neighbour_command", "friction:neighbour_command")


def found(left, acts_on="actuator"):
    effect = SimpleNamespace(
        name="neighbour-command", acts_on=acts_on, coordinates=("friction:neighbour_command",)
    )
    search = SimpleNamespace(
        corrected=SimpleNamespace(effects=(effect,)),
        verdict=SimpleNamespace(coordinates=left),
        rounds=[SimpleNamespace(before={"friction": [1], "load": [1]})],
    )
    return SimpleNamespace(search=search)


def test_the_sensor_is_pointed_at_with_the_coordinate():
    assert "does neighbour command reach the torque's sensor" in or_sensor_sentence(found(BOTH))


@pytest.mark.parametrize("left", [(), BOTH[:1], BOTH[1:], ("load:time", "friction:time")])
def test_not_where_one_balance_alone_or_another_coordinate_has_it(left):
    assert or_sensor_sentence(found(left)) == ""


def test_not_of_a_sensors_own_error():
    assert or_sensor_sentence(found(BOTH, acts_on="sensor")) == ""
