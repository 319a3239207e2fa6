"""The two records every kernel function works on: what a model is, and where a run keeps its state.

Arrays are flat; in the reference engine they are lists, in the compiled engine NumPy arrays.  What
depends on the integration method has room for the one with most stages.
"""

from collections import namedtuple

#: Modes of a clutch; one that has just been switched on has none yet.
BACKWARD, STICK, FORWARD, FREE, PENDING = -1, 0, 1, 2, 3
#: Gates: off, waiting for the off-to-on delay to pass, on.
OFF, CLOSING, ON = 0, 1, 2

#: Why a run ends, besides 0, the end of its time: 1 to 5 as ``settle``, and these.  ``FULL`` is no
#: end but a record without room; ``STOPPED`` and ``FAILED`` are by a guard of the model.
NO_NUMBER, ZENO, TOO_SHORT, FULL, STOPPED, FAILED = 6, 7, 8, 9, 10, 11
MANY_EVENTS, INCOMPATIBLE, MANY_STEPS, HALTED, NOT_HELD = 20, 21, 22, 23, 24
#: What a held input that is no finite number may be, by number; it ends a run as ``NOT_HELD``.
NO_FINITE = ("nan", "inf", "-inf")
#: What a jump hands back at a stop that ends the run as meant; 3 at one that fails it.
ENDS = 2
#: What is logged of an event, by number (``compiled.KINDS`` in words).
STARTED, SWITCHED, SLIP_STOPPED, JUMPED, BROKEN_AWAY = 0, 1, 2, 3, 4
#: Counts of a run in ``rec.n``: events, segments, steps kept, guards that fell, steps taken.
EVENTS, SEGMENTS, STEPS_KEPT, FALLEN, STEPS = 0, 1, 2, 3, 4
#: What is kept of every case: its status, the guard or clutch that ended it, then those counts.
STATUS, WHY, COUNTS = 0, 1, 2

#: The most facets of a redundantly stuck set that are followed.
FACET_LIMIT = 64

#: A model: sizes, its functions (assembled in ``simpter_hybrid.assembly.model``), parameters ``p``,
#: recorded data ``rec``, per-clutch switch-on ``delay`` [s] and off ``threshold`` (command units),
#: ``prompt``: 1 where the excitation follows the command without lag, and ``smooth``: 1 where
#: friction is a smooth function of states and never sticks; per effect state ``begins``: number
#: (from 1) of the state with which it begins a run (an excitation, a speed), 0 if at zero.
#: ``constant``: the clutch map does not depend on q.  ``feedback``: clutch torques are needed
#: (controller or effect states).
Model = namedtuple(
    "Model",
    "n m nz ng ny constant feedback map terms rates watch control jump p rec delay threshold "
    "prompt smooth begins",
)

#: Everything a run changes or scribbles on.  ``fr``: friction torques in blocks of m (slip now,
#: breakaway forward/backward, slip at 0+ forward/backward); ``Q``: generalized forces in blocks of
#: n (load, effects, conservative); ``g``: guard values; ``meta``: rank, facets, whether
#: ``flow`` left the loads out; ``released``: direction in which a clutch was let go at the instant
#: ``stamp[0]``, 0 for the others.  From ``K`` on: the compiled engine's own.
Work = namedtuple(
    "Work",
    "M C c f Q fr B qdd tau lam a fy fp g s A d dsize lo hi x xx rows cols pick pivots index state "
    "zero hold mode gate t_on held mem dmode pattern meta yv stamp released K y_new y_try scratch "
    "F G recent before looks since low high clear",
)


def fields(**names: str) -> dict[str, str]:
    """Kinds of a record's fields by name, from the names of every kind, in the order given."""
    return {name: kind for kind, words in names.items() for name in words.split()}


#: Records of the compiled engine, kept as 8-byte slots: kinds of their fields (``i`` integer,
#: ``v`` one that may change from outside at any time, ``f`` float, ``A``/``I`` flat array of
#: floats/integers); see ``simpter_hybrid.lowering``.
COMPILED = {
    #: ``Model``; its functions are addresses.
    "md": fields(
        i="n m nz ng ny constant feedback map terms rates watch control jump",
        A="p rec delay threshold",
        I="prompt smooth begins",
    ),
    #: Options, breakpoints of the loads, restarts of the motion, and output instants of a run;
    #: once ``halt`` is not 0 it ends after the step that it is at.
    "o": fields(
        v="halt",
        f="t_end period rtol atol max_step",
        i="event_limit step_limit record nh nd nbreaks njumps nrestarts ngrid",
        A="breaks jumps restart_t restart_y grid rows",
    ),
    #: What runs leave behind; ``n``: counts (``EVENTS`` and the following).
    "rec": fields(
        A="event_t segment_t helds step_t step_h step_y step_f",
        I="event_i modes gates dmodes step_segment n",
        i="event_room segment_room step_room",
    ),
    #: The cases of a call, one row each.
    "many": fields(
        i="first last parameters_width data_width reals integers",
        A="parameters starts delay threshold data rows end ends",
        I="counts",
    ),
}


def events_at_once(m):
    """So many events of `m` clutches within ``AT_ONCE`` have no end (Zeno)."""
    return 40 + 10 * m


def work_arrays(n, m, ny, ng, nh, nmem, nd, reals, integers):
    """A ``Work`` for the given sizes; ``reals(k)``, ``integers(k)`` make zeroed arrays (k,)."""
    big = max(n, m) + 1
    guards = 2 * m + ng + 2 * FACET_LIMIT
    return Work(
        M=reals(n * n),
        C=reals(m * n + 1),
        c=reals(m + 1),
        f=reals(n),
        Q=reals(3 * n),
        fr=reals(5 * m + 1),
        B=reals(n * n),
        qdd=reals(n),
        tau=reals(m + 1),
        lam=reals(n),
        a=reals(m * n + 1),
        fy=reals(FACET_LIMIT * n),
        fp=reals(FACET_LIMIT * m + 1),
        g=reals(guards),
        s=reals(4 * big * big + 8 * big),
        A=reals(m * m + 1),
        d=reals(m + 1),
        dsize=reals(m + 1),
        lo=reals(m + 1),
        hi=reals(m + 1),
        x=reals(m + 1),
        xx=reals(m + 1),
        rows=integers(m + 1),
        cols=integers(n),
        pick=integers(2 * (m + n) + 1),
        pivots=integers(n + 1),
        index=integers(m + 1),
        state=integers(m + 1),
        zero=integers(m + 1),
        hold=integers(m + 1),
        mode=integers(m + 1),
        gate=integers(m + 1),
        t_on=reals(m + 1),
        held=reals(nh + 1),
        mem=reals(nmem + 1),
        dmode=integers(nd + 1),
        pattern=reals(m + 1),
        meta=integers(4),
        yv=reals(ny),
        stamp=reals(1),
        released=integers(m + 1),
        K=reals(16 * ny),
        y_new=reals(ny),
        y_try=reals(ny),
        scratch=reals(ny),
        F=reals(7 * ny),
        G=reals(10 * guards),
        recent=reals(events_at_once(m)),
        before=integers(m + 1),
        looks=reals(13 * guards),
        since=reals(guards),
        low=reals(guards),
        high=reals(guards),
        clear=integers(guards),
    )
