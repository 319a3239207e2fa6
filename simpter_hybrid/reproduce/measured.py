"""The thesis's own measurements diagnosed: residual, what it points to, error before and after."""

from __future__ import annotations

from functools import lru_cache
from itertools import pairwise

import numpy as np

# A form is preferred if it lowers the error on what was left out as much as in a diagnosis.
from ..identification.tracing.rivals import LEAST_GAIN
from . import measured_steps as steps
from . import measured_torque as torque
from .friction_fits import BASE, FITS, SPEEDS, TABLE_3, TABLE_4, VOLTS, polynomial
from .rows import Engine, Row, claim, uncomparable

#: Level at which lack of fit counts.
LEVEL = 0.01
#: Breakaway was determined from this excitation on [V].
LOWEST = 2.25
#: Lag of the data acquisition alone, its output wired to its input (4.6.1, Figure 21) [s].
CHAIN = 0.004
#: Levels between which a further step experiment is looked for [V]; above 8 V the supply tripped.
LEVELS = (0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0)


@lru_cache(maxsize=1)
def torque_forms() -> dict[str, torque.Judged]:
    """Every form of the course with speed, fitted and judged."""
    return {form.name: torque.judge(form) for form in torque.FORMS}


@lru_cache(maxsize=1)
def step_forms() -> dict[str, tuple[np.ndarray, float, float]]:
    """Every form of the actuator: values, error, error on steps left out [s]."""
    found = {}
    for form in steps.FORMS:
        x = steps.fitted(form)
        error = steps.rms(steps.errors(form.make(x)))
        found[form.name] = x, error, steps.rms(steps.left_out(form))
    return found


def measured(engine: Engine) -> list[Row]:
    """Slip torque against speed, step responses, breakaway (nothing is simulated anew)."""
    return [*speed_rows(), *step_rows(), *breakaway_rows()]


def speed_rows() -> list[Row]:
    """Tables 3 and 4 against (39)."""
    from scipy.stats import f as fisher

    forms = torque_forms()
    before, best = forms["(39) refitted"], min(forms.values(), key=lambda j: j.left_out)
    floor = float(np.sqrt(torque.PURE.sum() / 246.0))
    printed = float(np.sqrt(sum(sse for sse, _ in TABLE_4) / 246.0))
    # Of six quadratics' 18 numbers each form leaves as many as it has not.
    allowed, of_best = (
        float(fisher.ppf(1.0 - LEVEL, 18 - len(form.values), 228)) for form in (before, best)
    )
    tried = ", ".join(f"{j.name} {j.error:.2f} ({j.left_out:.2f})" for j in forms.values())
    return [
        claim(
            "A18 A19", "(39) leaves only what each speed's own quadratic leaves",
            f"{printed:.2f} lb-in against {floor:.2f}",
            f"refitted {before.error:.2f} lb-in, F = {before.lack_of_fit:.1f}, not {allowed:.1f}",
            before.lack_of_fit < allowed,
            why="what is left depends on speed: (39) lies above the measured torque at the lowest "
            "and highest speeds and below it between",
            floor=floor, as_printed=printed, refitted=before.error,
        ),
        claim(
            "A18", "no other course with speed predicts a speed left out better than (39) does",
            "a linear factor",
            f"lb-in, all six (each left out): {tried}",
            best.left_out > (1.0 - LEAST_GAIN) * before.left_out,
            why=f"{best.name} named: one parameter more, {before.left_out:.2f} -> "
            f"{best.left_out:.2f} lb-in on speeds that had no part in the fit",
            best=best.name, before=before.left_out, after=best.left_out, values=best.values,
        ),
        claim(
            "A18", f"with {best.name} nothing is left",
            "not said",
            f"{best.error:.2f} lb-in, F = {best.lack_of_fit:.1f}",
            best.lack_of_fit < of_best,
            why="form incomplete: the fits' term linear in v grows from "
            f"{FITS[1][1]:g} to {FITS[5][1]:g} lb-in/V between {SPEEDS[1]:g} and {SPEEDS[5]:g} "
            "rad/s, which no factor on the whole torque gives, nor an added drag",
        ),
        uncomparable(
            "A15 A17", "dependence on excitation, direction, angle, temperature, wear",
            "246 points, one direction", "the quadratics alone",
            "the points are lost, so nothing but a quadratic in v can be asked for; one decade of "
            "speed (0.194 to 1.990 rad/s); one way; neither temperature nor order are printed",
        ),
    ]  # fmt: skip


def step_rows() -> list[Row]:
    """Four step responses against the declared lag and delay."""
    forms = step_forms()
    declared = steps.rms(steps.errors(steps.DECLARED))
    before, best = forms["lag and gap refitted"], min(forms, key=lambda n: forms[n][2])
    after = forms[best]
    text = ", ".join(f"{n} {1e3 * e:.1f} ({1e3 * o:.1f})" for n, (_, e, o) in forms.items())
    rival = "slew-limit and dead time"
    start, volts, apart = next_step(best, rival)
    return [
        claim(
            "A8 A9 A10 A11", "a first-order lag on the command explains the four steps",
            "0.07 s and 0.02 s", f"declared {1e3 * declared:.1f} ms, refitted "
            f"{1e3 * before[1]:.1f} ms ({1e3 * before[2]:.1f} ms on a step left out)",
            before[2] <= after[2] / (1.0 - LEAST_GAIN),
            why="what is left depends on the size of the step: 22 ms for 3 V, 65 ms for 8 V; and "
            "12 ms of delay remain where there is no gap to close, of which by the "
            f"thesis {1e3 * CHAIN:g} ms may be its data acquisition's (output wired to input)",
            declared=declared, refitted=before[1], refitted_left_out=before[2],
        ),
        claim(
            "A7 A8 A9 A10 A11", f"{best} explain them",
            "not modelled", f"ms, all four (each left out): {text}",
            after[2] < 0.5 * before[2],
            why=f"{best} named; values {', '.join(f'{v:.3g}' for v in after[0])} (clamp in command "
            "volts with the maker's 0.124 s; gap and dead time in s)",
            after=after[1], after_left_out=after[2], values=after[0],
        ),
        uncomparable(
            "A11", "which kind of saturation it is", "7 numbers, 4 steps",
            f"{rival} leaves {1e3 * forms[rival][2]:.1f} ms on a step left out, {best} "
            f"{1e3 * after[2]:.1f} ms",
            f"not told apart; a step from {start:g} to {volts:g} V would: their constants differ "
            f"by {1e3 * apart:.0f} ms there; steps down are not printed at all",
            start=start, volts=volts, apart=apart,
        ),
    ]  # fmt: skip


def next_step(one: str, other: str) -> tuple[float, float, float]:
    """Rising step for which two fitted forms differ most in their constants: from, to [V], [s]."""
    forms = {form.name: form for form in steps.FORMS}
    pair = [forms[name].make(step_forms()[name][0]) for name in (one, other)]
    found = []
    for k, low in enumerate(LEVELS):
        for high in LEVELS[k + 1 :]:
            first, second = (steps.response(model, low, high)[1] for model in pair)
            found.append((low, high, abs(first - second)))
    return max(found, key=lambda item: item[2])


def breakaway_rows() -> list[Row]:
    """(43) against (39): what a model without a breakaway law lacks."""
    volts = VOLTS[VOLTS >= LOWEST]
    hold = np.polyval((6.648, 6.176, 5.253), volts)
    slip = torque.OFFSET * np.polyval(BASE, volts)
    share = float(slip @ hold / (slip @ slip))
    courses = {
        "none": np.zeros(volts.size), "a share of slip torque": (share - 1.0) * slip,
        "a constant": np.full(volts.size, float(np.mean(hold - slip))),
        "in proportion to v": volts * float(volts @ (hold - slip) / (volts @ volts)),
    }  # fmt: skip
    left = {n: float(np.sqrt(np.mean((hold - slip - c) ** 2))) for n, c in courses.items()}
    best = min(left, key=lambda n: left[n])
    ratio = hold / slip
    slowest = polynomial((6.060, -0.193, 1.496))[VOLTS >= LOWEST]
    seen = TABLE_3[0][1] / np.sqrt(41.0)
    fade = SPEEDS[0] / float(np.log(np.mean(hold - slowest) / (2.0 * seen)))
    falling = all(b < a for a, b in pairwise(ratio))
    return [
        claim(
            "A22 A24", "breakaway exceeds slip torque at rest by a fixed share",
            "both go with the normal force", f"{100 * (ratio[0] - 1):.0f} % at {volts[0]:g} V, "
            f"{100 * (ratio[-1] - 1):.0f} % at 10 V; left with "
            + ", ".join(f"{n}: {e:.1f} lb-in" for n, e in left.items()),
            best == "a share of slip torque",
            why=f"the excess goes {best}, not with v^2 as a normal force does; reading the highest "
            "sample before slip adds the noise's own peak, which is a constant",
            left=left, falling=falling,
        ),
        uncomparable(
            "A22 A23", "whether (43) itself lacks anything (rest time, ramp rate, repetition)",
            f"{VOLTS.size} runs from {VOLTS[0]:g} V on, {volts.size} of them ({LOWEST:g} V and "
            "up) with a level", "one quadratic without its sum of squares",
            f"below {LOWEST:g} V noise hid the level; no scatter is printed, so there is no floor "
            "to compare with; one run at each excitation, rest times and ramp rates not stated",
        ),
        uncomparable(
            "A24 A25", "over which speed breakaway falls to slip torque (Stribeck)",
            "nothing between 0 and 0.194 rad/s", f"if at all, within {fade:.3f} rad/s",
            "at 0.194 rad/s no excess above two standard errors is left; slower runs would tell",
            fade=fade,
        ),
    ]  # fmt: skip


def picture(engine: Engine):
    """Course with speed, and time constants of the steps, without and with what was found."""
    from ..plots.style import BLUE, GREY, INK, ORANGE, figure

    made = figure(3.4, "What the thesis's own measurements say of its clutch model")
    left, right = made.subplots(1, 2)
    forms, w = torque_forms(), np.linspace(0.05, 2.2, 80)
    middle = VOLTS >= LOWEST
    base = float(polynomial(BASE)[middle].mean())
    seen = [float(row[middle].mean()) / base for row in torque.FITTED]
    left.plot(SPEEDS, seen, "o", color=INK, label="measured (Table 3)")
    chosen = {form.name: form for form in torque.FORMS}
    for name, colour in (("(39) refitted", ORANGE), ("logarithmic-speed", BLUE)):
        course = [chosen[name].torque(forms[name].values, v)[middle].mean() / base for v in w]
        left.plot(w, course, color=colour, label=name)
    left.set(xlabel="slip speed / rad/s", ylabel="mean torque over that at 0.394 rad/s")
    left.legend()
    place = np.arange(4)
    right.plot(place, [1e3 * s[3] for s in steps.STEPS], "o", color=INK, label="measured")
    acts = {form.name: form for form in steps.FORMS}
    models = [("declared lag", steps.DECLARED, GREY)]
    for name, colour in (("lag and gap refitted", ORANGE), ("coil-supply and dead time", BLUE)):
        models.append((name, acts[name].make(step_forms()[name][0]), colour))
    for name, model, colour in models:
        told = [1e3 * steps.response(model, s[0], s[1])[1] for s in steps.STEPS]
        right.plot(place, told, "_", ms=22, mew=2, color=colour, label=name)
    right.set_xticks(place, [f"{s[0]:g} to {s[1]:g} V" for s in steps.STEPS])
    right.set(ylabel="time constant of torque / ms", ylim=(0, None))
    right.legend()
    return made
