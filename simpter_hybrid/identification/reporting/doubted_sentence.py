"""What is asked of a map and of sensors before a verdict, in one sentence."""

from __future__ import annotations

from collections.abc import Sequence

from ..doubted_channels import Doubt
from ..map_changes import OFF_AXIS, OWN_ZERO, RIPPLE
from ..percent import percent

#: Questions that are about a sensor and not about the map.
OF_SENSORS = {
    OFF_AXIS: f"is an {OFF_AXIS}",
    RIPPLE: "does a tachometer ripple",
    OWN_ZERO: "has a sensor another zero in each run (each read with nothing acting would tell)",
}
#: A change that leaves more than this part of the error is not said to leave "only" that.
ONLY = 0.9
#: ... and one that leaves up to so many times what noise would explains all there is.
BY_NOISE = 1.01
#: Most declared numbers that are told beside a unit.
OTHERS = 2


def doubted_sentence(doubts: Sequence[Doubt], noise: float = 0.0) -> str:
    """Sentence on which channel's sign, unit or `held` a user should look at first.

    `noise`: the part of the error of the runs that select which noise alone would leave.
    """
    if not doubts:
        return ""
    asked_of = {d.change.kind for d in doubts}
    kinds = asked_of - OF_SENSORS.keys()
    asked = [f"is a {' or a '.join(sorted(kinds))} in the map wrong"] if kinds else []
    asked += _of_sensors(doubts)
    every = sorted((n for d in doubts for n in d.numbers), key=lambda n: n.left)
    best = {n.name: n for n in reversed(every)}  # runs that fit and those that select ask of each
    numbers = sorted(best.values(), key=lambda n: n.left)[:OTHERS]
    if numbers:  # what leaves less is asked first
        word = "are declared numbers" if len(numbers) > 1 else "is a declared number"
        asked.insert(0 if numbers[0].left < doubts[0].left else len(asked), f"{word} far off")
    question = ", or ".join(asked)
    left = [(f"with {d.changed}", d.left) for d in doubts]
    left += [(f"with {n.said}", n.left) for n in numbers]
    if numbers:
        left.sort(key=lambda one: one[1])
    (with_it, part), *more = left
    others = "".join(f", {said} {percent(other)}" for said, other in more)
    # A mass on a spring with far too little friction declared asked for another unit of positions.
    unsure = "unit" in kinds and not numbers
    so = " A declared number that is far off may look like that." if unsure else ""
    if RIPPLE in asked_of and OFF_AXIS not in asked_of:
        so += f" An {OFF_AXIS} would show the same wave."
    only = "only " if part <= ONLY else ""
    noisy = ", no more than noise leaves" if ONLY < part <= BY_NOISE * noise else ""
    return (
        f"{question[0].upper()}{question[1:]}? {with_it[0].upper()}{with_it[1:]} {only}"
        f"{percent(part)} of the refitted model's error is left{noisy}{others}.{so}"
    )


def _of_sensors(doubts: Sequence[Doubt]) -> list[str]:
    """Questions about sensors; of an encoder that does not help the tachometer is asked as well."""
    kinds = {d.change.kind for d in doubts}
    if any(d.change.kind == OFF_AXIS and d.left > ONLY for d in doubts):
        kinds.add(RIPPLE)
    return [words for kind, words in OF_SENSORS.items() if kind in kinds]
