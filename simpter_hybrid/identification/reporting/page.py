"""The report of a diagnosis as one HTML file: pictures first, then tables."""

from __future__ import annotations

import base64
import html
from collections.abc import Mapping, Sequence
from typing import Any

from .by_curves import by_curves_text
from .dependence_table import dependence_table
from .meaning import INCOMPLETE, OR_NOISE
from .run_errors import run_table
from .tables import (
    candidate_table,
    data_text,
    error_tables,
    number,
    sight_tables,
    table,
    width,
)

STYLE = """body{font:15px/1.5 system-ui,sans-serif;max-width:62rem;margin:1.5rem auto;
padding:0 1rem;color:#222}p{white-space:pre-line}
h1{font-size:1.3rem}h2{font-size:1.1rem;margin-top:2rem}
.verdict{font-size:1.25rem;border-left:.4rem solid #0072B2;padding:.4rem .8rem;background:#f3f7fb}
img{max-width:100%}
table{border-collapse:collapse;font-size:.9rem;display:block;overflow-x:auto}
td,th{padding:.15rem .7rem;text-align:right;border-bottom:1px solid #e4e4e4}
td:first-child,th:first-child{text-align:left}
pre{background:#f6f6f6;padding:.7rem;overflow:auto;font-size:.8rem}"""
#: Sentences above the verdict ...
DOUBTED = (
    "failed", "doubted", "apart", "far_off", "pace", "driver", "ruling_run", "cut_off", "odd_rows",
    "cut_short",
)  # fmt: skip
#: ... and below it.
TOLD = (
    "left_out", "one_direction", "dying_out", "late_speed", "or_sensor", "passed_over", "unsized",
    "unborne", "outdone", "hardly_fitted", "beyond_fitted", "worse", "spoilt", "harmful", "uneven",
    "unsteady", "few_windows", "one_run", "at_limit", "less_drag", "refit", "rings", "repeated",
    "nearly_repeated", "between_rows", "no_place", "creeping", "swings", "repeats",
)  # fmt: skip
#: Condition of an interval: it knows of noise, and not of how far a law is off.
IF_RIGHT = "if the laws are right"
#: ... where the search itself found that one is not, or that one may not be.
BY_NOISE = "by noise alone: a form is incomplete, and a true value may well lie outside"
BY_KNOWN_NOISE = (
    "by the noise that was allowed for: a form is incomplete, or there is more noise, and a true "
    "value may well lie outside"
)
TRUST = (
    "How far this search can be trusted on these runs: <code>--trials N</code> counts its false "
    "alarms on synthetic sets of them in which nothing more is missing; "
    "<code>--without NAME</code> asks whether the lack of what was found is unknown to it "
    "then, and not something else."
)
CSP = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"


def page(data: Mapping[str, Any], pictures: Mapping[str, bytes], model: str) -> str:
    """The page of `diagnosis_data`'s dictionary, with PNG pictures and the corrected model."""
    title = f"Diagnosis of {html.escape(data['data']['recording'])}"
    images = "".join(
        f'<img alt="{name.replace("_", " ")}" '
        f'src="data:image/png;base64,{base64.b64encode(png).decode()}">'
        for name, png in pictures.items()
    )
    body = "\n".join([f"<h1>{title}</h1>", *_said(data), images, *_tables(data, model)])
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{CSP}">'
        f"<title>{title}</title><style>{STYLE}</style></head><body>\n{body}\n</body></html>\n"
    )


def _said(data: Mapping[str, Any]) -> list[str]:
    """What a reader decides from: doubts, the verdict, and what has to be known of it."""
    return [
        *(_paragraph(data[key]) for key in DOUBTED if data[key]),
        f'<p class="verdict">{html.escape(data["sentence"])}</p>',
        _paragraph(data["kind"]),
        _paragraph(_fitted(data["parameters"], _meant(data))),
        *(_paragraph(data[key]) for key in TOLD if data[key]),
        _own_values(data["run_to_run"]),
        _paragraph(data["empirical"]["sentence"]) if data["empirical"] else "",
        _paragraph(data["trials"]) if data["trials"] else "",
        _paragraph(data["next"]) if data["next"] else "",
        _paragraph(data["blindness"]) if data["blindness"] else "",
    ]


def _tables(data: Mapping[str, Any], model: str) -> list[str]:
    """What stands behind it, and the corrected model."""
    cut = bool(data["cut_short"]) and not data["unfinished"]  # a pass that is used
    return [
        "<h2>Error on the runs held out</h2>",
        error_tables(data),
        "<h2>Error on the runs that fit and select</h2>",
        run_table(data["error_of_runs"]),
        "<h2>Parameters</h2>",
        _parameters(data["parameters"], _meant(data)),
        "<h2>Candidates</h2>",
        *(candidate_table(k, r, cut) for k, r in enumerate(data["rounds"])),
        _paragraph(_refused(data["not_fitted"], cut)),
        "" if data["trials"] else f"<p>{TRUST}</p>",
        "<h2>On what the residual depends</h2>",
        dependence_table(data["rounds"], data["straight"], bool(data["effects"])),
        _paragraph(by_curves_text(data)),
        "<h2>What these experiments see</h2>",
        sight_tables(data["sees"]),
        "<h2>Which data were used for what</h2>",
        data_text(data["data"]),
        "<h2>The corrected model</h2>",
        _changes(data.get("model_diff", ())),
        f"<pre>{html.escape(model)}</pre>",
        f"<p>Seed {data['seed']}; "
        + html.escape(", ".join(f"{k} {v}" for k, v in data["versions"].items()))
        + "</p>",
        _paragraph(_asked(data["asked"])),
    ]


def _asked(options: Mapping[str, Any]) -> str:
    """Options as a person reads them: lists by their entries, and none if they are empty."""
    told = {k: ", ".join(v) if isinstance(v, list) else v for k, v in options.items()}
    return "Asked: " + "; ".join(f"{k} {v}" for k, v in told.items() if v != "") + "."


def _paragraph(text: str) -> str:
    return f"<p>{html.escape(text)}</p>"


def _meant(data: Mapping[str, Any]) -> str:
    """What an interval means beside such a verdict, as its sentence has it."""
    if OR_NOISE in data["sentence"]:
        return BY_KNOWN_NOISE
    incomplete = data["verdict"] == "form incomplete" or INCOMPLETE in data["sentence"]
    return BY_NOISE if incomplete else IF_RIGHT


def _parameters(parameters: Sequence[Mapping[str, Any]], meant: str) -> str:
    """Everything that was fitted, declared numbers as times their values."""
    head = ("parameter (of a declared one: times its value)", "fitted", f"± 95 % {meant}",
            "largest correlation")  # fmt: skip
    rows = (
        (
            p["name"],
            f"{number(p['value'])} {p['unit'] if p['unit'] != '1' else ''}".rstrip(),
            width(p),
            f"{p['largest_correlation']:.2f} with {p['with']}" if p["with"] else "",
        )
        for p in parameters
    )
    return table(head, rows)


def _refused(names: Sequence[str], cut: bool) -> str:
    if not names:
        return ""
    ended = "the search ended before, " if cut else ""
    return (
        f"Not fitted in the first round, since {ended}a linear step on the fitted runs promised "
        "too little, a simpler form did, or nothing was left for a richer form to explain: "
        f"{', '.join(names)}."
    )


def _own_values(told: Mapping[str, Any] | None) -> str:
    """Parameters that differ from run to run, run by run."""
    if told is None:
        return ""
    # Where they do not explain it all.
    said = _paragraph(told["sentence"]) if told["sentence"] else ""
    apart = told["parameters"]
    head = ("run", *(f"{p['parameter']}, {p['counted']}" for p in apart))
    rows = (
        (of[0]["run"], *(f"{row.get('over_median', row.get('above_median')):.4g}" for row in of))
        for of in zip(*(p["runs"] for p in apart), strict=True)
    )
    note = "<p>Reported runs, and the corrected model, have the common value.</p>"
    return said + table(head, rows) + ("" if said else note)


def _changes(diff: Sequence[str]) -> str:
    if not diff:
        return "<p>As declared.</p>"
    lines = html.escape("\n".join(diff))
    return f"<p>What changed (- declared, + corrected):</p><pre>{lines}</pre><p>All of it:</p>"


def _fitted(parameters: Sequence[Mapping[str, Any]], meant: str) -> str:
    """Sizes of what was found, with their 95 % intervals."""
    sizes = [
        f"{p['name']} {number(p['value'])} ± {width(p)} {p['unit']}".rstrip()
        for p in parameters
        if p["found"]
    ]
    return f"Fitted: {'; '.join(sizes)} (± 95 % {meant})." if sizes else ""
