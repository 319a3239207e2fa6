"""A part that reads what comes with a recorded run is marked, and no file may name it."""

import importlib
import pkgutil

import pytest

from simpter_hybrid import controllers, effects, loads
from simpter_hybrid.part import Part, arguments_of, functions_of
from simpter_hybrid.reading.kinds import shipped

#: They ask for `rec` to hand it on to the loads.
HAND_ON = {"tip_force_now"}
FAMILIES = {"controller": controllers, "load": loads, "effect": effects}


def classes(package):
    for info in pkgutil.iter_modules(package.__path__):
        module = importlib.import_module(f"{package.__name__}.{info.name}")
        own = [c for c in vars(module).values() if getattr(c, "__module__", "") == module.__name__]
        yield from (c for c in own if isinstance(c, type) and issubclass(c, Part))


@pytest.mark.parametrize("family", FAMILIES)
def test_what_reads_a_recording_is_no_kind(family):
    for cls in classes(FAMILIES[family]):
        asked = {name for f in functions_of(cls).values() for name in arguments_of(f)}
        if "rec" in asked and not asked & HAND_ON:
            assert cls.plays_recording, cls.__name__
        assert (cls in shipped(family).values()) != cls.plays_recording, cls.__name__
