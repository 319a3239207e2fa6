"""Whether the clutches and coordinates that parts name by number are there."""

from __future__ import annotations

import dataclasses

from ..controller import held_side_by_side
from ..controllers.axis_servo import DRIVE_INPUTS
from ..part import Part, arguments_of
from ..problems import KeyPath, Problems
from ..scenario import Scenario


def check_indices(s: Scenario, problems: Problems) -> None:
    """Record every number of a clutch or coordinate that the device, or the drives, do not have.

    Parameters
    ----------
    s : Scenario
    problems : Problems
    """
    held = held_side_by_side(stage for stage, _ in s.controllers)
    for path, part in _places(s):
        before = len(problems)
        for f in dataclasses.fields(part):
            if of := f.metadata.get("index"):
                _check_index(s, (*path, f.name), of, getattr(part, f.name), problems)
        if len(problems) == before:
            _check_drive(part, held, path, problems)


def _places(s: Scenario) -> list[tuple[KeyPath, Part]]:
    found: list[tuple[KeyPath, Part]] = []
    for key, parts in (("loads", s.loads), ("stops", s.stops), ("effects", s.effects)):
        found += [((key, k), part) for k, part in enumerate(parts)]
    found += [(("controller", "stages", k), stage) for k, (stage, _) in enumerate(s.controllers)]
    return found


def _check_index(s: Scenario, path: KeyPath, of: str, value: float, problems: Problems) -> None:
    names = s.device.surfaces if of == "clutch" else s.device.coordinates
    if value not in range(len(names)):
        told = ", ".join(f"{k} for {name}" for k, name in enumerate(names))
        right = f"a {of} of {type(s.device).__name__}, as counted in Python: {told}"
        problems.add(path, f"no such {of}", f"{value:g}", right)


def _check_drive(part: Part, held: list[str], path: KeyPath, problems: Problems) -> None:
    """A part finds its coordinate's drive behind the first one: the stages have to hold it."""
    at = getattr(part, "coordinate", -1)
    asked = {name for f in part.functions().values() for name in arguments_of(f)}
    for name in DRIVE_INPUTS if at >= 0 else ():
        wanted = f"{name}_{int(at) + 1}"
        if f"at_{name}_1" in asked and f"{name}_1" in held and wanted not in held:
            right = "a stage of the controller that writes it, such as a position-servo there"
            what = f"no stage holds {wanted}, the input of its coordinate"
            problems.add((*path, "coordinate"), what, f"{at:g}", right)
