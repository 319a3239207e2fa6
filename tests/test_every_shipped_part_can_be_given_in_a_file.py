"""Parts say what each of their fields measures, so that a scenario file can give it with a unit."""

import dataclasses

import pytest

from simpter_hybrid.known_units import BY_COORDINATE
from simpter_hybrid.reading.kinds import FAMILIES, kind_of, shipped
from simpter_hybrid.units import expected_quantity, si_unit

PARTS = [
    pytest.param(family, kind, cls, id=f"{family}-{kind}")
    for family in FAMILIES
    for kind, cls in shipped(family).items()
]


@pytest.mark.parametrize(("family", "kind", "cls"), PARTS)
def test_every_field_has_a_dimension_or_names_something(family, kind, cls):
    for f in dataclasses.fields(cls):
        if f.type in ("float", float):
            assert {"dimension", "index"} & f.metadata.keys(), f"{cls.__name__}.{f.name}"
            dimension = f.metadata.get("dimension", "dimensionless")
            for known in BY_COORDINATE.get(dimension, {"": dimension}).values():
                assert expected_quantity(known)
                si_unit(known)
        elif "columns" in f.metadata:
            for _, dimension in f.metadata["columns"]:
                for known in BY_COORDINATE.get(dimension, {"": dimension}).values():
                    assert expected_quantity(known)
        else:
            assert f.type in ("int", "bool", "str", int, bool, str), f"{cls.__name__}.{f.name}"


@pytest.mark.parametrize(("family", "kind", "cls"), PARTS)
def test_kind_and_class_name_each_other(family, kind, cls):
    assert kind_of(family, object.__new__(cls)) == kind


def test_the_kinds_that_files_use_are_there():
    assert {"testbed", "linear", "modified-quadratic", "table"} <= shipped("torque").keys()
    assert {"impedance-to-line", "impedance-to-circle", "lookup-table"} <= shipped(
        "controller"
    ).keys()
    assert {"operator", "torque-on-clutch", "piecewise-tip-force", "recorded-tip-force"} <= shipped(
        "load"
    ).keys()
    assert "pter" in shipped("device")
