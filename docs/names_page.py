"""Write docs/names-in-verdicts.md: every name that a verdict may have, and what it becomes.

    python docs/names_page.py [--check]

The names are those of the libraries that a diagnosis tries, on rigs of every kind.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from parts_page import first_sentence_of_module, written

from simpter_hybrid.files.scenario_file import load
from simpter_hybrid.identification.axis.candidates import (
    axis_candidates,
    with_friction_scale,
)
from simpter_hybrid.identification.axis.drive import drive_candidates, rippling
from simpter_hybrid.identification.axis.flexible import flexible_mode
from simpter_hybrid.identification.axis.let_go import released
from simpter_hybrid.identification.axis.motor import with_pulses
from simpter_hybrid.identification.axis.position_waves import Wave
from simpter_hybrid.identification.axis.pressed import pressed_library
from simpter_hybrid.identification.axis.set_points import set_point_candidates
from simpter_hybrid.identification.axis.sizes import AxisSizes
from simpter_hybrid.identification.axis.speed_sensor import BESIDE_NONE, late_speed, speed_offset
from simpter_hybrid.identification.maps import find_model
from simpter_hybrid.identification.rigs.effect_candidate import EffectCandidate
from simpter_hybrid.identification.rigs.temperature import temperature_library
from simpter_hybrid.identification.rotor.library import rotor_library
from simpter_hybrid.identification.tip.candidates import tip_candidates
from simpter_hybrid.identification.tip.joint_candidates import joint_candidates, late_clutches
from simpter_hybrid.identification.tip.structure import Scales, structure_candidates, torque_scales
from simpter_hybrid.reading.kinds import shipped

PAGE = Path(__file__).resolve().parent / "names-in-verdicts.md"
HEAD = """# Names in verdicts

Made by `python docs/names_page.py` from the libraries that a diagnosis tries. A name stands for a
form: an effect of the library with those of its parameters that are fitted, two effects together,
or an error of a sensor. What acts on friction is a factor on all of it, what is viscous included,
if its line does not say Coulomb friction or by so much. `-2` is a richer form, `-wave` repeats
along the way at any wavelength, `-N` (2 to 12) so many times a turn, `by clutch` and `by joint`
have a size for each. What it becomes in `corrected.toml` is in the third column: `[[effects]]` of
that kind ([parameters](devices-and-effects.md#effects)), a sensor's line in `[readings]`, or
other values of what was declared.

| name | rigs | in the corrected model | fitted | what it is |
|---|---|---|---|---|
"""
#: So many waves a turn.
MANY = re.compile(r"-([3-9]|1\d)$|(?<=ripple-force)-2$")
#: Names that are no effect of the library, or one of several forms of an effect, in words.
OTHERS = {
    "cross-coupling-fields": "The field of each other clutch's coil acts in this one's gap, by a "
    "gain for each pair of clutches.",
    "cross-coupling-next": "The field of the next clutch's coil acts in this one's gap (that of "
    "the first in the last's), by one gain.",
    "cross-coupling-others": "The fields of all other clutches' coils act in this one's gap, by "
    "one gain.",
    "cross-coupling-previous": "The field of the previous clutch's coil acts in this one's gap "
    "(that of the last in the first's), by one gain.",
    "command-offset": "The supply adds an offset to the command.",
    "motor sensor gain": "The sensor of the motor's torque shows too much or too little.",
    "motor sensor offset": "The sensor of the motor's torque has another zero.",
    "sensor gain": "The torque sensor shows too much or too little.",
    "sensor offset": "The torque sensor shows a constant beside the torque.",
    "sensor lag": "The torque sensor follows through a lag.",
    "sensor delay": "The torque sensor is late.",
    "force-gain": "The force sensor shows too much or too little.",
    "force-delay": "The force sensor is late.",
    "force-lag": "The force sensor follows through a lag.",
    "speed-offset": "The speed sensor has another zero, as a gyroscope's.",
    "speed-lag": "The speed is shown behind a filter, a lag of the first order.",
    "speed-delay": "The speed is shown late.",
    "speed-average-lag": "The speed is shown as such a mean, behind a filter.",
    "speed-average": "The speed is shown as the mean over a time before, as by counts.",
    "force-turned": "The force sensor is mounted turned.",
    "force-crosstalk": "Each axis of the force sensor shows a part of the force along the other.",
    "angle-gain": "The angle sensors show too much or too little.",
    "angle-offset": "The angle sensors have another zero.",
    "force-offset": "The force sensor shows a constant beside the force.",
    "tilt": "A constant force on the tip, as gravity gives where the robot stands tilted.",
    "tip-spring": "A spring from the tip to the frame (a cable).",
    "payload": "A mass on the tip.",
    "inertia": "Other inertias of the links.",
    "link-lengths": "Other lengths of the links.",
    "asymmetry-level": "Coulomb friction that differs between the two directions of slip.",
    "press-lag": "What presses an axis's friction acts through a lag (a coil, a valve).",
    "press-hysteresis": "What presses lags behind its turning points (a coil's remanence).",
    "press-power": "Friction that grows with a power of what presses it, not in proportion.",
    "press-scale": "What presses acts more or less than declared, and from another zero.",
    "motor-constant": "The motor has another torque constant (and back-EMF) than declared.",
    "motor-resistance": "The motor has another resistance than declared (when warm, say).",
    "dry-friction": "Coulomb friction where the declared model has none.",
    "drive-coasting": "A motor's driver that opens its ends between pulses: less back-EMF.",
    "command-delay": "A supply that does what it is told after a dead time.",
    "weight-dependent": "Friction that grows with what gravity and springs load, as a bearing's.",
    "drive-limit": "A motor's driver that gives no more than so much, however much it is told: of "
    "a motor driven by voltage, so much current.",
    "supply-limit": "A motor's supply that gives no more voltage than so much, however much is "
    "told.",
    "drive-delay": "A motor's driver that does what it is told after a dead time.",
    "reference-delay": "Set points that reach the servo after a dead time.",
    "time-constant": "The clutches' excitation has another time constant than declared.",
    "breakaway-scale": "The clutch breaks away at another multiple of the declared torque.",
    "friction-scale": "Dry friction is another multiple of the declared, beyond tolerance.",
    "torque-scale": "The clutches' torque is another multiple of the declared, beyond tolerance.",
}


def main() -> int:
    """Write or check the page."""
    return written(PAGE, HEAD + "\n".join(lines()) + "\n", Path(__file__).name)


def lines() -> Iterator[str]:
    """A line a name; forms that differ in the number of waves or in being one a clutch share it."""
    forms: dict[str, list[tuple[str, EffectCandidate]]] = {}
    for rig, candidates in libraries().items():
        for c in candidates:
            forms.setdefault(MANY.sub("-N", c.name.partition(" by ")[0]), []).append((rig, c))
    for name in sorted(forms, key=str.lower):
        all_of = [c for _, c in forms[name]]
        rigs = ", ".join(dict.fromkeys(rig for rig, _ in forms[name]))
        each = sorted({c.name.partition(" by ")[2] for c in all_of} - {""})
        fitted = dict.fromkeys(p.name.rpartition(".")[2] for c in all_of for p in c.parameters)
        made = " or ".join(dict.fromkeys(becomes(c) for c in all_of))
        also = f" Also `by {each[0]}`." if each else ""
        yield f"| {name} | {rigs} | {made} | {', '.join(fitted)} | {words(all_of[0])}{also} |"


def libraries() -> dict[str, tuple[EffectCandidate, ...]]:
    """What is tried on each kind of rig; sizes do not matter here."""
    wave, turn = Wave(5.0, 0.1, 0.1), 2 * math.pi
    axis = axis_candidates(
        AxisSizes(1.0, 1.0, 9 * turn, 1.0, 1.0, True, 0.0, 9 * turn), ((wave, wave),), pulled=True
    )
    known = {c.name for c in axis}  # what goes round and round has no ends
    slides = axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, False, 0.0, 1.0))
    axis = (*axis, *(c for c in slides if c.name not in known))
    rotor, slide = (load(str(find_model(name))) for name in ("testbed", "emps"))
    axis = with_friction_scale(axis, slide, 1.0)
    law = replace(slide.clutches[0].torque, coulomb=0.0)
    bare = slide.replace(clutches=(replace(slide.clutches[0], torque=law),))
    axis = (*axis, *with_friction_scale((), bare, 1.0))
    told = [load(str(find_model(name))) for name in ("emps", "bam_xl330")]
    told[1] = with_pulses(told[1], np.array([5.0]))
    driven = [
        c for model in told for sensed in (True, False) for c in drive_candidates(model, sensed)
    ]
    driven += [released(told[1].loads[0], 0.0)]
    driven += [*set_point_candidates(slide), speed_offset(1.0, True), *late_speed(BESIDE_NONE)]
    driven += [flexible_mode(1.0, 50.0, (), True), *rippling(slide, (wave,), turn)]
    robot = load(str(find_model("robot")))
    scales = Scales(**dict.fromkeys(Scales.__dataclass_fields__, 1.0))
    tip = tip_candidates(2, 4, (1.0, 1.0), 1.0, 1.0, "tilt by joint", (0.0, 0.0))
    arm = load(str(find_model("dfki_double_pendulum")))
    joints = joint_candidates(arm, (1.0, 1.0), 1.0, 1.0, (1.0, 1.0), (0, 1), (1.0, 1.0))
    lags = tuple(replace(clutch, time_constant=0.03) for clutch in arm.clutches)
    lagging = arm.replace(clutches=lags)
    warmed = temperature_library(1, 1, 293.0, 10.0, 1.0)
    return {
        "rotor": (*rotor_library(rotor), *warmed),
        "axis": (*axis, *pressed_library(1.0, True), *driven, *warmed),
        "robot": (*tip, *structure_candidates(robot, scales), *warmed),
        "two joints": (*joints, *torque_scales(arm, ()), *late_clutches(lagging, (0, 1)), *warmed),
    }


def becomes(c: EffectCandidate) -> str:
    """What stands in the corrected model."""
    kinds = {cls: kind for kind, cls in shipped("effect").items()}
    found = dict.fromkeys(f"`{kinds[type(e)]}`" for e in c.effects())
    if c.acts_on == "sensor":
        return "`[readings]`"
    if c.load is not None:
        return "a load"
    if c.stages:
        kinds = {cls: kind for kind, cls in shipped("controller").items()}
        return f"stage `{kinds[type(c.stages[0])]}`"
    if c.shifts or c.shares:
        return "declared values"
    return " and ".join(found) or "declared values"


def words(c: EffectCandidate) -> str:
    """The first sentence on each of its effects."""
    if c.name in OTHERS:
        return OTHERS[c.name]
    parts = c.stages or c.effects()
    found = dict.fromkeys(first_sentence_of_module(type(e)) + "." for e in parts)
    if c.load is not None:
        text = (type(c.load).__doc__ or "").split("\n\n")[0]
        return " ".join(text.split())
    return " ".join(found)


if __name__ == "__main__":
    raise SystemExit(main())
