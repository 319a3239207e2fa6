"""Switching clutches on and off: the excitation lag and the off-to-on delay (thesis 5.1)."""

import math


def switch(md, t, y, w):
    """Open and close clutches at a step's end; returns how many changed between off and on.

    A command above the threshold closes the gap after the delay, if it lasts; a clutch is off, and
    gives no torque, when its command and its excitation are at or below the threshold.
    """
    changed = 0
    for i in range(md.m):
        at = 2 * md.n + i
        wanted = w.held[i] > md.threshold[i]
        if wanted:
            if w.gate[i] == 0:
                w.gate[i] = 1
                w.t_on[i] = t + md.delay[i]
            if w.gate[i] == 1 and w.t_on[i] <= t:
                w.gate[i] = 2
                changed += 1
        elif w.gate[i] == 1:
            w.gate[i] = 0
        elif w.gate[i] == 2 and (md.prompt[i] == 1 or y[at] <= md.threshold[i] * (1.0 + 1e-9)):
            w.gate[i] = 0
            y[at] = 0.0
            changed += 1
        if md.prompt[i] == 1 and w.gate[i] == 2:
            y[at] = w.held[i]
    return changed


def next_known(md, t, y, dy, w, end):
    """The first known instant in (t, end] at which a clutch switches on, or off [s].

    An excitation that decays exponentially towards its command (``dy`` gives the rate) crosses the
    threshold at a known time; where an effect bends the decay this is a guess that is made again
    when it has passed.
    """
    for i in range(md.m):
        at = 2 * md.n + i
        if w.gate[i] == 1 and t < w.t_on[i] < end:
            end = w.t_on[i]
        elif w.gate[i] == 2 and w.held[i] <= md.threshold[i] < y[at] and dy[at] < 0.0:
            lag = (w.held[i] - y[at]) / dy[at]
            if lag > 0.0 and w.held[i] < md.threshold[i]:
                fall = t + lag * math.log((y[at] - w.held[i]) / (md.threshold[i] - w.held[i]))
                if t < fall < end:
                    end = fall
    return end
