"""``simpter list --parts``: an effect on a clutch takes no coordinate, and the other way round."""

from simpter_hybrid.commands.list import _parts


def _keys(name):
    (part,) = (p for p in _parts() if p["name"] == name)
    return {line.partition(" = ")[0] for line in part["keys"]}


def test_an_effect_has_one_place():
    assert "clutch" in _keys("effect dahl")
    assert "coordinate" not in _keys("effect dahl")
    assert "coordinate" in _keys("effect spring-force")
    assert "clutch" not in _keys("effect spring-force")
