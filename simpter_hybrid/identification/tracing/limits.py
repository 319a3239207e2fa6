"""Up to how many times the floor an error is noise: it depends on how the floor is known."""

from __future__ import annotations

from math import inf, isfinite
from typing import NamedTuple

from .locating import CLEAN, LEAST_DEPENDENCE
from .rivals import OFF_FLOOR

#: An error after `OFF_FLOOR` times the floor is always said to be an incomplete form, and where
#: nothing helps, something unknown.  Beyond this many times it is more than the forms of right
#: effects leave: those of own recordings end up to 16 % above the floor.
IMPERFECT = 1.2
#: The limit in place of `OFF_FLOOR` without replicates: an estimate from single runs misses
#: coloured noise.
OFF_NOISE = 1.5
#: The limit where windows of runs with a measured drive were repeated: their starts are fitted, and
#: a right model of an own motor leaves up to 1.06.
NEAR = 1.1


class Limits(NamedTuple):
    """Errors, in times the floor, up to which they are taken for noise.

    Parameters
    ----------
    lack : float
        Where no effect helps.
    form : float
        With an effect: beyond it its form is incomplete.
    dependence : float
        Part of the mean square that a dependence takes away which tells of a lack by itself.
    drive : bool
        Whether what drives the runs was seen by a sensor: such noise of it is not known.
    told : bool
        Whether what drives them was told to a driver whose own noise nobody knows: as a force it
        may be any number of times what sensors of a motion show.
    clean : float
        Up to where no dependence of a force tells of a lack.
    coarse : bool
        Whether rows are too far apart to know the floor: up to `clean` nothing is tried either.
    known_by : str
        What the floor is, for a reader.
    rounds : bool
        Whether the sensor of the motion rounds so coarsely that noise does not carry it across:
        what it leaves a right model comes again in a run driven again.
    doubt : float
        From here on no effect that helps and no dependence are no all-clear: it cannot be told.
    """

    lack: float = OFF_FLOOR
    form: float = OFF_FLOOR
    dependence: float = LEAST_DEPENDENCE
    drive: bool = False
    told: bool = False
    clean: float = CLEAN
    coarse: bool = False
    known_by: str = "floor of noise"
    rounds: bool = False
    doubt: float = inf

    @property
    def estimated(self) -> bool:
        """Whether the floor is estimated from single runs, and nothing was repeated."""
        return self.known_by == ESTIMATED

    @property
    def apart(self) -> bool:
        """Whether runs were repeated, and differ by more than the noise known otherwise."""
        return self.known_by == REPETITION and self.drive


#: What the floor is where nothing was repeated, and where measured drives were.
ESTIMATED, REPETITION = "noise estimated from single runs", "floor that repeated runs show"
#: Limits where runs were repeated that were told the same drive.
REPEATED = Limits()
#: Limits where the floor is estimated from single runs.
SINGLE = Limits(OFF_NOISE, OFF_NOISE, known_by=ESTIMATED)
#: Limits of a driven axis with such a floor.  A drive that is sampled coarsely, or noise of it that
#: is not white, puts curves of up to a seventeenth into nulls: a tenth is asked.  Of two driven
#: joints as well: white noise of measured torques put one of a fortieth, over time, into one of two
#: nulls.
SINGLE_AXIS = Limits(OFF_NOISE, OFF_NOISE, 0.1, known_by=ESTIMATED)
#: Limits of an axis whose noise of inputs and starts is simulated: nulls end 0.79 to 1.14 times
#: that floor, and one at 1.04 times it on one selecting run had a curve over time of a seventh.
SIMULATED_AXIS = Limits(OFF_NOISE, IMPERFECT, 0.1, clean=1.06, known_by=ESTIMATED)
#: Limits of such an axis with positions so far apart that friction bends the course within a
#: start's fit: nulls of another generator at 100 Hz ended at 0.4 to 1.7 times the floor and were
#: given names.
COARSE_AXIS = SIMULATED_AXIS._replace(form=OFF_NOISE, clean=OFF_NOISE, coarse=True)
#: Limits of such an axis with a drive whose sensor rounds so coarsely that noise does not carry it
#: across.  What rounding leaves out is simulated as lasting as long as a value does, and lasts
#: longer where a servo holds a level: a null ended at 1.4 times the floor on runs held out, and at
#: 2.3 on those that select.  Beyond the usual limit it cannot be told (a ball on a beam with a
#: number declared 1.65 times too large ended at 1.4, one with a force of 10 % too many at 2).
ROUNDED_AXIS = SIMULATED_AXIS._replace(form=3.0, clean=3.0, coarse=True)
#: Limits of a robot, whose noise is simulated too: 60 own nulls end 0.99 to 1.05 times that floor,
#: a tester's with noise that lasts 12 ms at 1.19; a bowed potentiometer ended at 1.41.  Between
#: these nobody knows: samples that came up to 2 ms late and a soft stop ended at 1.12 to 1.19.
#: Blocks are few (80 on the selecting runs): one null in a hundred passes the test of a dependence
#: by chance.
SIMULATED = Limits(1.25, OFF_FLOOR, drive=True, clean=1.03, doubt=1.1)


def known_by_repetition(limits: Limits, raised: float, sure: float) -> Limits:
    """Limits where runs were repeated that differ by `raised` times the noise otherwise known.

    If that is no more, what drives them is not noisier than was thought, and an error beyond three
    standard errors of that floor (relative: `sure`) is no noise; unless rows or a sensor are so
    coarse that a right model leaves more than what differs.  If it is more, something does not
    come again (slow noise, friction of another day), of which a few runs tell the size to a half:
    up to that half nothing is looked for, and nothing is missing.
    """
    if raised <= IMPERFECT:
        limits = limits._replace(drive=False, known_by=REPETITION)
        if limits.coarse or limits.rounds or not isfinite(sure):
            # What a coarse sensor leaves a right model comes again.
            return limits._replace(lack=max(limits.lack, limits.form)) if limits.coarse else limits
        limits = limits._replace(clean=min(limits.clean, CLEAN))
        near = max(NEAR, 1.0 + 3.0 * sure)
        return limits._replace(lack=min(limits.lack, near), form=min(limits.form, near))
    up_to = {name: max(OFF_NOISE, getattr(limits, name)) for name in ("lack", "form", "clean")}
    up_to["doubt"] = inf
    return limits._replace(**up_to, drive=True, coarse=True, known_by=REPETITION)
