"""A whole run: steps between known instants; modes are looked at when a step is finished."""

import math

from .flow import flow
from .gates import next_known, switch
from .records import FORCED, REJECTED, STEPS, WHICH
from .stepper import error_of, hermite, take_step
from .writing import keep_step, log_modes, open_segment, write_grid

#: Rounds of jumps at one instant; what is still down then acts at the end of the next step.
JUMPS = 5
FINISHED, SINGULAR, NOT_FINITE, CHATTER, NOT_HELD, FULL, STOPPED = 0, 1, 6, 7, 8, 9, 10


def run(md, o, breaks, w, y, rec):
    """Run from 0 to ``o.t_end``; returns (status, t, stop or held input that ended it, or -1)."""
    t = 0.0
    sampled = 0
    at_break = 0
    start(md, o, t, y, w, rec)
    h = 0.0
    while t < o.t_end:
        for i in range(o.nh):
            # Such a command would switch its clutch off, being above no threshold.
            if not math.isfinite(w.held[i]):
                return NOT_HELD, t, i
        if rec.n[STEPS] + rec.n[REJECTED] >= o.limit:
            return CHATTER, t, -1
        target = min(o.t_end, (sampled + 1) * o.period) if o.period > 0.0 else o.t_end
        while at_break < o.nbreaks and breaks[at_break] <= t:
            at_break += 1
        if at_break < o.nbreaks:
            target = min(target, breaks[at_break])
        target = next_known(md, t, y, w.k1, w, target)
        size = step_size(o, t, target, h, y, w)
        if take_step(md, o, t, y, size, w) != 0:
            return SINGULAR, t, -1
        if not finite(md.ny, w.y_new) or not finite(md.ny, w.k7):
            return NOT_FINITE, t, -1
        if o.variable == 1:
            error = error_of(o, y, size, w)
            if error > 1.0 and size > o.min_step:
                h = max(o.min_step, size * max(0.1, 0.8 * error**-0.2))
                rec.n[REJECTED] += 1
                continue
            if error > 1.0:
                rec.n[FORCED] += 1
            h = next_size(error, size, h)
        which, x = fallen_within(md, o, t, size, w, y)
        room = keep_step(md, o, t, size, x, y, w, rec)
        if not room and not 0 <= which < o.stops:
            return FULL, t, -1
        t = reach(md, o, t, target, size, which, x, y, w)
        if 0 <= which < o.stops:
            return STOPPED, t, which
        sampled, jumped = act(md, o, sampled, t, y, w)
        if not finish_step(md, o, t, y, w, rec, jumped):
            return FULL, t, -1
    return FINISHED, t, -1


def drive(md, o, breaks, w, y, rec):
    """``run`` for one who takes a single number: the status; the others go into ``rec``."""
    status, t, which = run(md, o, breaks, w, y, rec)
    rec.end[0] = t
    rec.n[WHICH] = which
    return status


def finite(count, y):
    """Whether the entries of ``y`` are finite."""
    total = 0.0
    for j in range(count):
        total += y[j]
    return math.isfinite(total)


def start(md, o, t, y, w, rec):
    """The first sample, with no torque before it, and the first entry of the record."""
    for i in range(md.m):
        w.last[i] = 0.0
        w.seen[i] = 2
        if w.mode[i] == 3:
            w.mode[i] = 2
    flow(md, o, t, y, w, w.k1)
    control(md, 0, t, y, w)
    switch(md, t, y, w)
    finish_step(md, o, t, y, w, rec, True)
    write_grid(md, t, 0.0, y, w, rec, 0.0)


def control(md, sampled, t, y, w):
    """Let the controllers act; they read the limited speeds and the latest torques."""
    for j in range(md.ny):
        w.y_try[j] = y[j]
    for j in range(md.n):
        w.y_try[md.n + j] = w.speed[j]
    for i in range(md.m):
        w.tau[i] = w.now[i]
    md.control(sampled, t, w.y_try, w.tau, md.p, md.rec, w.s, w.held, w.mem)


def step_size(o, t, target, h, y, w):
    """Size of the next step [s]: up to the known instant ``target``, in equal parts if fixed."""
    if o.variable == 0:
        return (target - t) / max(math.ceil((target - t) / o.step - 1e-9), 1)
    if h == 0.0:
        # ode45's first step: a hundredth of what the tolerance allows, here simply cautious.
        size = 1e-3 * o.max_step
        for j in range(o.span):
            rate = abs(w.k1[j]) / max(abs(y[j]), o.atol / o.rtol)
            if rate * size > 0.8 * o.rtol**0.2:
                size = 0.8 * o.rtol**0.2 / rate
        h = size
    h = min(h, o.max_step)
    return target - t if t + 1.0000001 * h >= target else h


def next_size(error, size, h):
    """What the next step may take [s] after one of ``size`` that was kept, whatever its error."""
    grow = 5.0 if error < 1e-4 else min(5.0, 0.8 * error**-0.2)
    # A step cut short by a known instant says little about the next one.
    return max(size * grow, h) if size < h and error <= 1.0 else size * grow


def fallen_within(md, o, t, size, w, y):
    """The guard that falls first in the step just taken and the fraction where, or (-1, 1.0).

    Stop conditions come before guards of effects; of several that fall at one instant the first
    in their order, as with the exact engine.  A fixed step has no part: effects jump at its end.
    """
    which = -1
    first = 1.0
    count = md.ng if o.variable == 1 else o.stops
    if count == 0:
        return which, first
    md.watch(t + size, w.y_new, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.out)
    for g in range(count):
        if w.out[2 * md.m + g] < 0.0:
            x = where_fallen(md, g, t, size, w, y)
            # One that was down before the step began acts at its end.
            if x < first and (g < o.stops or x > 0.0):
                first = x
                which = g
            elif which < 0 and g < o.stops:
                which = g
            md.watch(t + size, w.y_new, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.out)
    return which, first


def where_fallen(md, g, t, size, w, y):
    """Fraction of the step at which guard ``g`` is first seen to be down, by bisection."""
    low = 0.0
    high = 1.0
    md.watch(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.out)
    if w.out[2 * md.m + g] < 0.0:
        return 0.0
    for _ in range(60):
        x = 0.5 * (low + high)
        hermite(md.ny, y, size, w, x, w.y_try)
        md.watch(t + x * size, w.y_try, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.out)
        if w.out[2 * md.m + g] < 0.0:
            high = x
        else:
            low = x
    return high


def reach(md, o, t, target, size, which, x, y, w):
    """Go to the end of the step, or to where guard ``which`` fell; returns that instant."""
    if which >= 0:
        t += x * size
        hermite(md.ny, y, size, w, x, w.y_new)
    else:
        t = target if t + size >= target else t + size
    for j in range(md.ny):
        y[j] = w.y_new[j]
    w.reached[0] = t
    if which >= o.stops:
        # What samples and clutches look at belongs to the end of the step.
        flow(md, o, t, y, w, w.k7)
    return t


def act(md, o, sampled, t, y, w):
    """What happens at the end of a step; returns (number of samples, whether anything jumped)."""
    jumped = jump(md, o, t, y, w)
    if o.period > 0.0 and t >= (sampled + 1) * o.period and t < o.t_end:
        sampled += 1
        control(md, sampled, t, y, w)
        jump(md, o, t, y, w)
        jumped = True
    if switch(md, t, y, w) > 0:
        jumped = True
    if o.limiter == 2 and reset(md, o, y, w):
        jumped = True
    return sampled, jumped


def jump(md, o, t, y, w):
    """Let the effects jump whose guards are down; whether any did.

    A jump may bring another one's guard down, or its own next: a contact that is met at once.
    """
    if md.ng == o.stops:
        return False
    found = False
    for _ in range(JUMPS):
        again = False
        md.watch(t, y, md.p, md.rec, w.held, w.mode, w.dmode, w.s, w.out)
        for g in range(o.stops, md.ng):
            if w.out[2 * md.m + g] < 0.0:
                md.jump(g, t, y, md.p, md.rec, w.held, w.dmode)
                again = True
        if not again:
            break
        found = True
    return found


def reset(md, o, y, w):
    """Give the speeds their limited values; whether that changed any by more than rounding."""
    changed = False
    for j in range(md.n):
        if abs(y[md.n + j] - w.speed[j]) > 1e-9 * o.band:
            changed = True
        y[md.n + j] = w.speed[j]
    return changed


def finish_step(md, o, t, y, w, rec, jumped):
    """Carry the derivative over, remember the torques, log the modes.  False: a record is full."""
    if jumped:
        flow(md, o, t, y, w, w.k1)
    else:
        for j in range(md.ny):
            w.k1[j] = w.k7[j]
    changed = False
    for i in range(md.m):
        w.last[i] = w.now[i]
        w.before[i] = w.seen[i]
        w.seen[i] = w.mode[i]
        if w.before[i] != w.seen[i]:
            changed = True
    if changed and not log_modes(md, t, w, rec):
        return False
    if changed or jumped:
        return open_segment(md, o, t, w, rec)
    return True
