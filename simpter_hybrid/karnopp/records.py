"""The records that the Karnopp simulator's flat functions work on."""

from __future__ import annotations

from collections import namedtuple

from ..kernel.records import fields

#: Choices and solver settings as numbers.  ``limiter`` as in ``rules.LIMITERS``; ``both``,
#: ``resolve``, ``relative``, ``table`` 0/1; ``variable`` 0/1; ``step`` [s] of the fixed solver;
#: ``span`` entries of y that the error estimate looks at; ``stops`` conditions that end the run
#: (the first guards of the model); ``record`` 0/1; ``limit`` of steps tried; ``nbreaks`` instants
#: at which a load has a corner.
Options = namedtuple(
    "Options",
    "band limiter both resolve relative table variable step rtol atol max_step min_step "
    "t_end period span stops record nh nd limit nbreaks",
)

#: The model's functions and numbers; per-clutch ``delay`` [s], ``threshold``, ``prompt``, and
#: ``smooth``: 1 where an effect gives the friction as a function of states, with its own sign.
Model = namedtuple(
    "Model", "n m ng ny map terms rates watch control jump p rec delay threshold prompt smooth"
)

#: Everything a run changes.  The arrays that the model's functions fill (``M C c f Q fr s``), the
#: state of clutches and controllers (``mode gate t_on held mem dmode``), and Karnopp's own:
#: ``slip`` speeds, ``last`` torques of the last finished step and ``now`` of the latest evaluation,
#: flags ``stuck``, ``over`` (at breakaway), ``flag``, modes ``seen`` and ``before``, ``speed`` the
#: limited speeds, stages ``k1 ... k7``; ``count`` of evaluations; ``reached`` the end of the last
#: step [s]; the others are scratch.
Work = namedtuple(
    "Work",
    "M C c f Q fr qdd tau s mode gate t_on held mem dmode slip last now stuck over flag seen "
    "before speed rhs x r d e along weight a k1 k2 k3 k4 k5 k6 k7 y_new y_try out count reached",
)

#: What a run leaves behind.  ``n``: events, segments, steps, evaluations, rejected steps, steps
#: accepted at the least step size, grid position.
Record = namedtuple(
    "Record",
    "n event_t event_mode segment_t mode gate held dmode step_t step_h step_y step_f step_segment "
    "grid rows end step_room segment_room ngrid",
)

EVENTS, SEGMENTS, STEPS, EVALUATIONS, REJECTED, FORCED, GRID, WHICH = 0, 1, 2, 3, 4, 5, 6, 7

#: These records for the compiler: kinds of their fields, as in ``kernel.records.COMPILED``.
COMPILED = {
    "md": fields(
        i="n m ng ny map terms rates watch control jump", A="p rec delay threshold",
        I="prompt smooth",
    ),
    "o": fields(
        f="band step rtol atol max_step min_step t_end period",
        i="limiter both resolve relative table variable span stops record nh nd limit nbreaks",
    ),
    "rec": fields(
        I="n event_mode mode gate dmode step_segment",
        A="event_t segment_t held step_t step_h step_y step_f grid rows end",
        i="step_room segment_room ngrid",
    ),
}  # fmt: skip


#: The fields of ``Work`` that a scenario's own work arrays provide.
SHARED = Work._fields[: Work._fields.index("slip")]


def work_arrays(shared, n, m, ny, ng, reals, integers):
    """A ``Work`` around the arrays of a scenario (``scenario.initial``)."""
    k = max(n, m) + 1
    return Work(
        **{name: getattr(shared, name) for name in SHARED}, slip=reals(m), last=reals(m),
        now=reals(m), stuck=integers(m), over=integers(m), flag=integers(m), seen=integers(m),
        before=integers(m), speed=reals(n), rhs=reals(k), x=reals(k + 6), r=reals(k), d=reals(k),
        e=reals(k), a=reals(k * k), along=reals(k), weight=reals(k), k1=reals(ny),
        k2=reals(ny), k3=reals(ny), k4=reals(ny), k5=reals(ny), k6=reals(ny),
        k7=reals(ny), y_new=reals(ny), y_try=reals(ny),
        out=reals(2 * m + ng + 1), count=integers(4), reached=reals(1),
    )  # fmt: skip
