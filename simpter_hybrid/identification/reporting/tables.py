"""Tables of a report in HTML, from `diagnosis_data`'s dictionary."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

#: Why a channel may lie above the declared model's error and the weighed sum still be at the floor.
PLAIN = (
    "<p>A channel's row is the plain difference; of positions that are set anew in windows, "
    "without the straight line that an error of a window's start makes (a constant error of the "
    "speed does not show there). The last row weighs it: by the channel's noise "
    "and, where inputs or starts of windows are noisy too, by what their noise does to the "
    "prediction. Such noise can rule a channel's plain error; the verdict goes by the last row.</p>"
)
#: Models whose errors are shown, in this order.
STAGES = ("declared", "refitted", "after", "empirical", "floor")
#: Repeated runs that differ by so many times the noise of the sensors are not alike.
SCATTERS = 1.5
#: Most breakaways listed; the JSON has all.
LISTED = 20
#: A run in which something shows by less than this [deviations of noise] is not listed.
LEAST_SHOWN = 0.05
#: Beside the gain of a candidate that has ended with size zero.
IDLE = " (its size is zero: the refit beside it)"
#: ... and of one that counts for nothing, whatever the selecting runs say.
BY_CHANCE = " (not on the fitted runs: by chance)"

#: Beside a fitted number that is no estimate, for it went no farther than it might.
AT_BOUND = " (at its bound)"


def error_tables(data: Mapping[str, Any]) -> str:
    """Errors on the runs held out: per channel, all weighed, per experiment, of breakaways."""
    errors, noise = data["error_of_channels"], data["noise_of_channels"]
    stages = [s for s in STAGES if s in errors]
    rows = []
    for channel in errors["after"]:
        unit, scale = data["units_of_channels"].get(channel, ("SI", 1.0))
        unit = "relative" if channel == "breakaway" else unit
        every = [errors[s].get(channel) for s in stages]
        least = errors["floor"].get(channel) or noise.get(channel)
        times = number(errors["after"][channel] / least) if least else "-"
        shown = (number(None if e is None else e / scale) for e in every)
        own = noise.get(channel)
        own = number(None if own is None else own / scale)
        rows.append((f"{channel.replace('_', ' ')} [{unit}]", *shown, own, times))
    floor = data["error"]["floor"]
    weighed = (number(data["error"][s] / floor) for s in stages)
    last = number(data["error"]["after"] / floor)
    rows.append(("all, weighed, times the floor of noise", *weighed, "", last))
    head = ("channel", *stages, "noise of the sensor", "after, times floor (or noise)")
    tests = "".join(_tested(stage, test) for stage, test in data["lack_of_fit"].items())
    notes = PLAIN + _beside(data["not_compared"]) + _scatters(errors["floor"], noise) + tests
    return table(head, rows) + notes + _experiments(data) + _breakaways(data)


def _beside(channels: Sequence[str]) -> str:
    """A word on measured channels that have no row."""
    if not channels:
        return ""
    names = " and ".join(c.replace("_", " ") for c in channels)
    return f"<p>Measured, but not compared, so that no row tells of it: {names}.</p>"


def _scatters(floor: Mapping[str, float], noise: Mapping[str, float]) -> str:
    """A word on floors that no sensor explains."""
    far = [(c, floor[c] / n) for c, n in noise.items() if n and floor.get(c, 0.0) > SCATTERS * n]
    if not far:
        return ""
    times = ", ".join(f"{c.replace('_', ' ')} by {number(x)}" for c, x in far)
    return (
        f"<p>Repeated runs differ by more than the noise of their sensors ({html.escape(times)} "
        "times): the rig itself does not repeat better (friction that scatters, another start). "
        "The floor is what they differ by.</p>"
    )


def _tested(stage: str, test: Mapping[str, float | None]) -> str:
    """One sentence on a test of lack of fit."""
    against = test["floor_freedom"]
    noise = (
        "a noise that was estimated or declared"
        if against is None
        else (f"what repeated runs differ by ({against:,.0f} degrees of freedom)")
    )
    sure = "" if against is not None else " if that noise were known exactly"
    return (
        f"<p>Lack of fit, {stage}: the mean square is {number(test['ratio'])} times that of "
        f"{noise}, p = {number(test['p_value'])}{sure}. Of {test['samples']:,} samples "
        f"{test['freedom']:,.0f} count as independent (Bartlett, by their autocorrelation).</p>"
    )


def _experiments(data: Mapping[str, Any]) -> str:
    apart = data["error_of_experiments"]
    if len(apart) < 2:
        return ""
    stages = [s for s in STAGES if any(s in of for of in apart.values())]
    rows = ((name, *(number(of.get(s)) for s in stages)) for name, of in apart.items())
    return table(("experiment, times the floor of noise", *stages), rows)


def _breakaways(data: Mapping[str, Any]) -> str:
    """Measured and predicted levels in the channel's unit, the run's longest rests first."""
    if not (rows := data["breakaways"]):
        return ""
    shown = sorted(rows, key=lambda r: -r["rested"])[:LISTED]
    unit, scale = data["units_of_channels"].get("clutch_torque", ("N m", 1.0))
    head = (f"breakaway [{unit}]", "at [s]", "after a rest of [s]", "measured", "± 2 sd",
            "refitted", "after")  # fmt: skip
    cells = (
        (r["run"], number(r["time"]), number(r["rested"]),
         *(number(level / scale)
           for level in (r["measured"], 2 * r["sd"], r["refitted"], r["after"])))
        for r in shown
    )  # fmt: skip
    most = f"<p>The {len(shown)} after the longest rests, of {len(rows)}.</p>"
    return table(head, cells) + (most if len(shown) < len(rows) else "")


def candidate_table(k: int, done: Mapping[str, Any], cut: bool = False) -> str:
    """Table of the candidates tried in a round, taken or refused; `cut`: the search ended early."""
    rows = (
        (
            t["name"], t["port"], f"{100 * t['gain']:.2f} %{_why(t)}",
            _interval(t["held_out"]),
            f"{t['share']:.3f}",
            ", ".join(f"{n.removeprefix(t['name'] + '.')} {number(v)}"
                      + AT_BOUND * (n in t.get("at_bound", ())) for n, v in t["values"].items()),
        )
        for t in done["candidates"]
    )  # fmt: skip
    asked = [t["held_out"] for t in done["candidates"] if t["held_out"]]
    within = "" if all(one["of_runs"] for one in asked) else ", within these runs"
    head = (
        "candidate", "acts on", "fall of the error on selecting runs",
        f"on runs held out (95 %{within})", "share explained", "fitted",
    )  # fmt: skip
    title = f"<h3>Round {k + 1}: {html.escape(done['verdict'])}</h3>"
    if not done["candidates"]:
        why = "none promised enough, or the floor is so uncertain that none was asked"
        why = f"the search ended before, or {why}" if cut else why
        return f"{title}<p>None was fitted: {why}.</p>"
    return title + table(head, rows)


def _why(trial: Mapping[str, Any]) -> str:
    """Words beside the gain of a candidate that has not earned it."""
    if trial["idle"]:
        return IDLE
    return BY_CHANCE if trial["by_chance"] else ""


def _interval(held_out: Mapping[str, Any] | None) -> str:
    if held_out is None:
        return "-"
    ends = "-"
    if held_out["low"] is not None:
        ends = f"{100 * held_out['low']:.3g} to {100 * held_out['high']:.3g}"
    return f"{100 * held_out['gain']:.2f} % ({ends})"


def sight_tables(sees: Mapping[str, Any] | None) -> str:
    """What the experiments are blind to and confuse, and the run that would tell."""
    if sees is None:
        return "<p>Not computed.</p>"
    blind = ", ".join(sees["blind_to_classes"]) or "none of the library"
    small = "if small (some per cent of friction, or of the largest force)"
    same = "".join(
        f" {name} is the declared {tolerance} itself, which is refitted."
        for name, tolerance in sees["same_as"].items()
    )
    text = f"<p>Blind to, {small}: {html.escape(f'{blind}.{same}')}</p>"
    shown = ((name, _runs(found) or "none of these") for name, found in sees["shown_by"].items())
    if sees["shown_by"]:
        text += table(("blind to", "run next (signal in noise deviations)"), shown)
    if sees["experiments"]:
        planned = table(("planned run", "what is laid down in it"), sees["experiments"].items())
    else:
        planned = ""
    if not sees["cannot_separate"]:
        return text + planned
    rows = (
        (
            " and ".join(p["pair"]),
            "contested" if p["imitated"] is None else f"{100 * p['imitated']:.0f} %, if small",
            "; ".join(filter(None, [_runs(p["run_next"]), *p["otherwise"]])),
        )
        for p in sees["cannot_separate"]
    )
    head = ("cannot be told apart", "imitated", "run next (distance in noise deviations)")
    return text + table(head, rows) + planned


def _runs(ranked: Iterable[Mapping[str, Any]]) -> str:
    return "; ".join(
        f"{e['experiment']} ({e['distance']:.1f}"
        + (f"; {e['needed']:.1f} are needed)" if e["needed"] is not None else ")")
        for e in ranked
        if e["distance"] >= LEAST_SHOWN
    )


def data_text(data: Mapping[str, Any]) -> str:
    """Text on which data were used for what, and what was found wrong with them."""
    used = "; ".join(f"{k}: {', '.join(v)}" for k, v in data["used_for"].items())
    findings = "".join(f"<li>{html.escape(f)}</li>" for f in data["findings"])
    absent = ", ".join(data["absent"]) or "nothing"
    text = f"{data['runs']} runs. {used}. Not recorded: {absent}."
    digests = ", ".join(f"{what} {digest[:16]}" for what, digest in data.get("sha256", {}).items())
    text += f" SHA-256: {digests}." if digests else ""
    return f"<p>{html.escape(text)}</p>" + (f"<ul>{findings}</ul>" if findings else "")


def table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Rows under a head."""
    top = "".join(f"<th>{html.escape(h)}</th>" for h in head)
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(str(c))}</td>" for c in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def width(parameter: Mapping[str, Any]) -> str:
    """Half the width of a parameter's 95 % interval, as text."""
    half = parameter["half_width"]
    return "anything (these data do not show it)" if half is None else number(half)


def number(value: float | None) -> str:
    """A number with four digits, as text; - where there is none."""
    return "-" if value is None else f"{value:.4g}"
