"""A run as one HTML file that opens anywhere, also offline and from a mail attachment."""

from __future__ import annotations

import base64
import html
import json
import re
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from ..explanation.explain import explain_event, segments_around
from ..measuring.energy import EnergyBalance, energy_balance
from ..measuring.metrics import Metrics, measures
from ..measuring.sampling import sample
from ..plots import SI, Display, figures, png
from ..trajectory import Event, Trajectory
from ..versions import versions
from .report_data import animation

#: Events beyond these are listed without an explanation.
EXPLAINED = 300
MODE_NAMES = {-1: "backward", 0: "stuck", 1: "forward", 2: "off", 3: "off"}
CAPTIONS = {
    "tip_path": "Where the tip went. Triangles: breakaways (up) and stops of slip (down); pale: "
    "the linkage at equal intervals of time; dark: at the end.",
    "slip_velocities": "A stuck clutch has exactly zero slip velocity: it has lost that degree of "
    "freedom. Lines: the events of that clutch.",
    "clutch_torques": "The blue band is what a clutch could hold if it were at rest now. While it "
    "holds, its torque lies inside the band and breaks away at its border.",
    "torque_following": "What the controller asked of each clutch, and what it gave.",
    "acceleration": "At a transition acceleration jumps: both sides are shown, joined by dots.",
    "energy_budget": "Work and dissipation are integrated along the motion, not obtained by "
    "difference; what is missing is a check of the whole computation.",
}


def report_html(
    trajectory: Trajectory,
    scenario_text: str = "",
    display: Display = SI,
    pictures: Mapping[str, bytes] | None = None,
) -> str:
    """The report of a run.

    Parameters
    ----------
    trajectory : Trajectory
    scenario_text : str
        The resolved scenario, shown as it stands.
    display : Display
        Units shown.
    pictures : mapping of str to bytes, optional
        PNG files by the names that ``plots.figures`` gives; drawn when left out.

    Raises
    ------
    ValueError
        For a run that failed before it began.
    """
    if trajectory.t_end == 0.0:
        raise ValueError(f"the run has no duration to report on: {trajectory.message}")
    samples = sample(trajectory)
    if pictures is None:
        drawn = figures(trajectory, samples, display)
        pictures = {name: png(picture) for name, picture in drawn.items()}
    balance, measured = energy_balance(trajectory, samples), measures(trajectory)
    parts = {
        "title": html.escape(trajectory.scenario.name),
        "verdict": html.escape(verdict(trajectory)),
        "notes": paragraphs(trajectory),
        "tiles": tiles(trajectory, measured, balance, display),
        "figures": "\n".join(_figure(name, picture) for name, picture in pictures.items()),
        "events": event_rows(trajectory),
        "metrics": metric_rows(measured, display),
        "energy": energy_rows(trajectory, balance, display),
        "scenario": html.escape(scenario_text or "(made in Python; no text)"),
        "statistics": _rows({k: str(v) for k, v in trajectory.statistics.items()}),
        "versions": _rows(versions() | {"engine": trajectory.engine}),
        "data": json.dumps(animation(trajectory, display)).replace("</", "<\\/"),
        "script": _resource("report.js"),
        "style": _resource("report.css"),
    }
    return re.sub(
        r"\{\{(\w+)\}\}", lambda found: parts[found[1]], _resource("report_template.html")
    )


def write_report(
    trajectory: Trajectory,
    path: str | Path,
    scenario_text: str = "",
    display: Display = SI,
    pictures: Mapping[str, bytes] | None = None,
) -> Path:
    """Write ``report_html`` to a file; returns its path."""
    path = Path(path)
    path.write_bytes(report_html(trajectory, scenario_text, display, pictures).encode())
    return path


def _resource(name: str) -> str:
    return files("simpter_hybrid.report").joinpath(name).read_text(encoding="utf-8")


def verdict(trajectory: Trajectory) -> str:
    """How the run ended, in a sentence."""
    lead = {
        "finished": "The run finished",
        "stopped": "The run stopped as planned",
        "interrupted": "The run was interrupted; what follows is what had been computed",
        "failed": "THE RUN FAILED; what follows is what had been computed",
    }
    return f"{lead.get(trajectory.status, trajectory.status)}: {trajectory.message}."


def number(value: Any, unit: str, display: Display) -> str:
    """A value or a tuple of values in the units shown."""
    if value is None:
        return "none"
    if isinstance(value, tuple):
        return ", ".join(number(v, unit, display) for v in value)
    if isinstance(value, int):
        return str(value)
    return f"{value * display.factor(unit):.4g}"


def paragraphs(trajectory: Trajectory) -> str:
    """What the scenario says about itself."""
    own = trajectory.scenario.notes
    answers = own.get("answers_to")
    inferred = ", ".join(own.get("inferred", ()))
    label = f"Inferred, not given by the source (marked in the scenario below): {inferred}."
    texts = (
        own.get("about"), f"Answers to: {answers}" if answers else None,
        label if inferred else None,
    )  # fmt: skip
    return "\n".join(f"<p>{html.escape(str(text))}</p>" for text in texts if text)


def tiles(
    trajectory: Trajectory, measured: Metrics, balance: EnergyBalance, display: Display
) -> str:
    """The few numbers to be seen first."""
    shown = [("duration", f"{measured.run_time:.4g} s")]
    if measured.average_error is not None:
        error = number(measured.average_error, "m", display)
        shown.append(("average path error", f"{error} {display.unit('m')}"))
    shown += [
        ("events", str(len(trajectory.events))),
        ("transitions (flat portions)", str(measured.transitions)),
        (
            "energy taken from the user",
            f"{number(measured.energy_from_user, 'J', display)} {display.unit('J')}",
        ),
    ]
    if balance.relative is not None:
        shown.append(("energy balance missed by", f"{balance.relative:.1e}"))
    return "\n".join(
        f'<div class="tile"><b>{html.escape(value)}</b><span>{html.escape(name)}</span></div>'
        for name, value in shown
    )


def _figure(name: str, picture: bytes) -> str:
    code = base64.b64encode(picture).decode("ascii")
    words = name.replace("_", " ")
    return (
        f'<figure id="{name}"><img alt="{words}" src="data:image/png;base64,{code}">'
        f"<figcaption>{html.escape(CAPTIONS[name])}</figcaption></figure>"
    )


def _chips(mode: tuple[int, ...]) -> str:
    return "".join(
        f'<i class="chip {MODE_NAMES[code]}" title="clutch {i + 1}: {MODE_NAMES[code]}">{i + 1}</i>'
        for i, code in enumerate(mode)
    )


def event_rows(trajectory: Trajectory) -> str:
    """The event table; each row goes to its instant and tells why."""
    rows = []
    around = segments_around(trajectory)
    for k, event in enumerate(trajectory.events):
        text, note = "", event.note
        if k < EXPLAINED:
            explanation = explain_event(trajectory, k, around)
            text = str(explanation)
            note = "; ".join(part for part in (event.note, explanation.note) if part)
        rows.append(_event_row(event, text, note))
    return "\n".join(rows)


def _event_row(event: Event, text: str, note: str) -> str:
    case = f"{event.case_before} → {event.case_after}" if event.case_before else ""
    why = '<button type="button" class="link why">why?</button>' if text else ""
    answer = f'<tr hidden><td colspan="7"><pre>{html.escape(text)}</pre></td></tr>' if text else ""
    goto = f'<button type="button" class="link goto" data-t="{event.t!r}">{event.t:.6f}</button>'
    cells = (
        goto,
        html.escape(event.kind),
        ", ".join(map(str, event.clutches)),
        f"{_chips(event.before)} → {_chips(event.after)}",
        html.escape(case),
        why,
        html.escape(note),
    )
    return "<tr>" + "".join(f"<td>{cell}</td>" for cell in cells) + f"</tr>{answer}"


def metric_rows(measured: Metrics, display: Display) -> str:
    """The table of measures."""
    rows = []
    for entry in measured.as_dict().values():
        value = entry["value"]
        value = tuple(value) if isinstance(value, list) else value
        unit = display.unit(entry["unit"])
        cells = (entry["label"], number(value, entry["unit"], display), unit)
        rows.append("<tr>" + "".join(f"<td>{html.escape(c)}</td>" for c in cells) + "</tr>")
    return "\n".join(rows)


def energy_rows(trajectory: Trajectory, balance: EnergyBalance, display: Display) -> str:
    """The energy budget from the start to the end."""
    names = {
        "stored at the start": balance.stored_start,
        "work of the loads": balance.work_load,
        "work of the effects": balance.work_effects,
        **{
            f"dissipated by {surface}": lost
            for surface, lost in zip(
                trajectory.scenario.device.surfaces, balance.dissipated, strict=True
            )
        },
        "stored at the end": balance.stored_end,
    }
    unit = display.unit("J")
    rows = {name: f"{number(value, 'J', display)} {unit}" for name, value in names.items()}
    if balance.residual is not None:
        rows["largest imbalance"] = f"{balance.residual * display.factor('J'):.1e} {unit}"
    rows["largest power delivered by a clutch"] = f"{balance.max_clutch_power:.1e} W"
    return _rows(rows)


def _rows(values: dict[str, str]) -> str:
    return "\n".join(
        f"<tr><td>{html.escape(name)}</td><td>{html.escape(value)}</td></tr>"
        for name, value in values.items()
    )
