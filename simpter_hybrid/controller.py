"""What acts at sample instants: controllers, servos, recorded commands."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import ClassVar

from .part import Part


@dataclass(frozen=True)
class Controller(Part):
    """Base of controllers: a static ``step(...)`` that reads the state and writes held inputs.

    ``step`` returns nothing.  It may ask by name for ``k`` (sample number, an int), ``time`` [s],
    ``q`` (n,) [rad or m], ``qd`` (n,) [rad/s or m/s], ``tau`` (m,) (clutch torques [N m], if
    ``feedback``), ``p`` (all parameters) with ``table_at`` (where its table begins there), ``rec``,
    ``held`` (written: its first m entries are the clutch commands [V], the others those that
    ``holds`` names, from ``at_<name>`` on), ``desired_count`` (clutches, from the first on, whose
    desired torques are held from ``at_desired_1`` on), ``mem`` with ``mem_at`` (memory, read and
    written), ``s`` (scratch), any of its parameters, and any function of the device.  What a force
    sensor at the tip reads [N] is in ``out[0:2]`` after ``tip_force_now(time, state, p, rec, held,
    s, out)``, ``out = s[2:6]`` or beyond; ``state`` is what loads need of the run, and no reading
    of a ``Measurement`` stands for it, as one may for ``q`` and ``qd``.
    """

    #: Whether ``step`` reads the clutch torques.
    feedback: ClassVar[bool] = False
    #: Names of memory cells; they start at 0.
    memory: ClassVar[tuple[str, ...]] = ()
    #: Held inputs beyond the clutch commands that this controller writes.
    holds: ClassVar[tuple[str, ...]] = ()
    #: Names that later stages get from this one's memory instead, and where there (n cells each).
    replaces: ClassVar[dict[str, int]] = {}
    #: Number of coordinates and least number of clutches of the devices it is for; (0, 0): any.
    made_for: ClassVar[tuple[int, int]] = (0, 0)
    #: The most coordinates it serves (0: any number), and past samples it keeps of what it delays.
    most_coordinates: ClassVar[int] = 0
    kept_samples: ClassVar[int] = 0
    #: Whether it hands on, at every sample, what the stages before it tell: it acts on what was
    #: recorded of them too.
    hands_on: ClassVar[bool] = False
    #: Held inputs that it reads and writes anew: ``command``, or names without their number; it is
    #: given what the stages before it told last, however often they act.
    rewrites: ClassVar[tuple[str, ...]] = ()

    def held_inputs(self) -> tuple[str, ...]:
        """`holds`; of a stage that serves one of several coordinates, as far as that one."""
        return self.holds


def held_side_by_side(controllers: Iterable[Controller]) -> list[str]:
    """All held inputs of a run's stages, those that a number tells apart one after the other.

    Parts find ``drive_3`` two places behind ``drive_1``, whatever stage holds which.

    Parameters
    ----------
    controllers : iterable of Controller
        In their order, which is that of the inputs otherwise.
    """
    names = dict.fromkeys(name for stage in controllers for name in stage.held_inputs())
    stems = [_numbered(name)[0] for name in names]
    return sorted(names, key=lambda name: (stems.index(_numbered(name)[0]), _numbered(name)[1]))


def _numbered(name: str) -> tuple[str, int]:
    stem, _, number = name.rpartition("_")
    return (stem, int(number)) if number.isdecimal() else (name, 0)
