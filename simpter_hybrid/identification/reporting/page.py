"""The report of a diagnosis as one HTML file: pictures first, then tables."""

from __future__ import annotations

import base64
import html
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

STYLE = """body{font:15px/1.5 system-ui,sans-serif;max-width:62rem;margin:1.5rem auto;
padding:0 1rem;color:#222}h1{font-size:1.3rem}h2{font-size:1.1rem;margin-top:2rem}
.verdict{font-size:1.25rem;border-left:.4rem solid #0072B2;padding:.4rem .8rem;background:#f3f7fb}
img{max-width:100%}
table{border-collapse:collapse;font-size:.9rem;display:block;overflow-x:auto}
td,th{padding:.15rem .7rem;text-align:right;border-bottom:1px solid #e4e4e4}
td:first-child,th:first-child{text-align:left}
pre{background:#f6f6f6;padding:.7rem;overflow:auto;font-size:.8rem}"""
CSP = "default-src 'none'; img-src data:; style-src 'unsafe-inline'"
#: Why a channel may lie above the declared model's error and the weighed sum still be at the floor.
PLAIN = (
    "<p>A channel's row is the plain difference. The last row weighs it: by the channel's noise "
    "and, where inputs or starts of windows are noisy too, by what their noise does to the "
    "prediction. Such noise can rule a channel's plain error; the verdict goes by the last row.</p>"
)


def page(data: Mapping[str, Any], pictures: Mapping[str, bytes], model: str) -> str:
    """The page of `diagnosis_data`'s dictionary, with PNG pictures and the corrected model."""
    images = "".join(
        f'<img alt="{name.replace("_", " ")}" '
        f'src="data:image/png;base64,{base64.b64encode(png).decode()}">'
        for name, png in pictures.items()
    )
    title = f"Diagnosis of {html.escape(data['data']['recording'])}"
    body = [
        f"<h1>{title}</h1>",
        f"<p>{html.escape(data['doubted'])}</p>" if data["doubted"] else "",
        f'<p class="verdict">{html.escape(data["sentence"])}</p>',
        f"<p>{html.escape(data['kind'])}</p>",
        f"<p>{html.escape(_fitted(data['parameters']))}</p>",
        *(f"<p>{html.escape(data[key])}</p>" for key in ("refit", "rings") if data[key]),
        _own_values(data["run_to_run"]),
        f"<p>{html.escape(data['empirical']['sentence'])}</p>" if data["empirical"] else "",
        f"<p>{html.escape(data['trials'])}</p>" if data["trials"] else "",
        f"<p>{html.escape(data['next'])}</p>" if data["next"] else "",
        images,
        "<h2>Error on the reported runs</h2>",
        _errors(data),
        "<h2>Candidates</h2>",
        *(_candidates(k, r) for k, r in enumerate(data["rounds"])),
        "<h2>Parameters</h2>",
        _table(
            (
                "parameter (of a declared one: times its value)",
                "fitted",
                "± 95 %",
                "largest correlation",
            ),
            (
                (
                    p["name"],
                    f"{_g(p['value'])} {p['unit']}",
                    _width(p),
                    f"{p['largest_correlation']:.2f}",
                )
                for p in data["parameters"]
            ),
        ),
        "<h2>What these experiments see</h2>",
        _sight(data["sees"]),
        "<h2>Which data were used for what</h2>",
        _data(data["data"]),
        "<h2>The corrected model</h2>",
        _changes(data.get("model_diff", ())),
        f"<pre>{html.escape(model)}</pre>",
        f"<p>Seed {data['seed']}; "
        + html.escape(", ".join(f"{k} {v}" for k, v in data["versions"].items()))
        + "</p>",
    ]
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f'<meta http-equiv="Content-Security-Policy" content="{CSP}">'
        f"<title>{title}</title><style>{STYLE}</style></head><body>\n"
        + "\n".join(body)
        + "\n</body></html>\n"
    )


def _own_values(told: Mapping[str, Any] | None) -> str:
    """Parameters that differ from run to run, run by run."""
    if told is None:
        return ""
    if told["sentence"]:  # they do not explain it
        return f"<p>{html.escape(told['sentence'])}</p>"
    apart = told["parameters"]
    head = ("run", *(f"{p['parameter']}, over the mean of the runs" for p in apart))
    rows = (
        (of[0]["run"], *(f"{row['over_mean']:.4g}" for row in of))
        for of in zip(*(p["runs"] for p in apart), strict=True)
    )
    note = "<p>Reported runs, and the corrected model, have the common value.</p>"
    return _table(head, rows) + note


def _changes(diff: Sequence[str]) -> str:
    if not diff:
        return "<p>As declared.</p>"
    lines = html.escape("\n".join(diff))
    return f"<p>What changed (- declared, + corrected):</p><pre>{lines}</pre><p>All of it:</p>"


def _fitted(parameters: Sequence[Mapping[str, Any]]) -> str:
    """Sizes of what was found, with their 95 % intervals."""
    sizes = [
        f"{p['name']} {_g(p['value'])} ± {_width(p)} {p['unit']}".rstrip()
        for p in parameters
        if "." in p["name"]
    ]
    return f"Fitted: {'; '.join(sizes)} (± 95 %)." if sizes else ""


def _errors(data: Mapping[str, Any]) -> str:
    errors = data["error_of_channels"]
    known = ("declared", "refitted", "after", "empirical", "floor")
    stages = [s for s in known if s in errors]
    rows = [(c.replace("_", " "), *(_g(errors[s].get(c)) for s in stages)) for c in errors["after"]]
    floor = data["error"]["floor"]
    times = (f"{data['error'][s] / floor:.4g}" for s in stages)
    rows.append(("all, weighed, times the floor of noise", *times))
    return _table(("channel [SI; breakaway relative]", *stages), rows) + PLAIN


def _candidates(k: int, done: Mapping[str, Any]) -> str:
    rows = (
        (
            t["name"], t["port"], f"{100 * t['gain']:.2f} %", f"{t['share']:.3f}",
            ", ".join(f"{n.removeprefix(t['name'] + '.')} {_g(v)}" for n, v in t["values"].items()),
        )
        for t in done["candidates"]
    )  # fmt: skip
    head = (
        "candidate",
        "acts on",
        "fall of the error on selecting runs",
        "share explained",
        "fitted",
    )
    return f"<h3>Round {k + 1}: {done['verdict']}</h3>" + _table(head, rows)


def _sight(sees: Mapping[str, Any] | None) -> str:
    if sees is None:
        return "<p>Not computed.</p>"
    blind = ", ".join(sees["blind_to_classes"]) or "none of the library"
    text = f"<p>Blind to, at typical size: {html.escape(blind)}.</p>"
    shown = ((name, _runs(found)) for name, found in sees["shown_by"].items())
    if sees["shown_by"]:
        text += _table(("blind to", "run next (signal in noise deviations)"), shown)
    if not sees["cannot_separate"]:
        return text
    rows = (
        (
            " and ".join(p["pair"]),
            "contested" if p["imitated"] is None else f"{100 * p['imitated']:.0f} %",
            "; ".join([_runs(p["run_next"]), *p["otherwise"]]),
        )
        for p in sees["cannot_separate"]
    )
    head = ("cannot be told apart", "imitated", "run next (distance in noise deviations)")
    return text + _table(head, rows)


def _runs(ranked: Iterable[Mapping[str, Any]]) -> str:
    return "; ".join(
        f"{e['experiment']} ({e['distance']:.1f}"
        + (f"; {e['needed']:.0f} settle it)" if e["needed"] is not None else ")")
        for e in ranked
    )


def _data(data: Mapping[str, Any]) -> str:
    used = "; ".join(f"{k}: {', '.join(v)}" for k, v in data["used_for"].items())
    findings = "".join(f"<li>{html.escape(f)}</li>" for f in data["findings"])
    absent = ", ".join(data["absent"]) or "nothing"
    text = f"{data['runs']} runs. {used}. Not recorded: {absent}."
    return f"<p>{html.escape(text)}</p>" + (f"<ul>{findings}</ul>" if findings else "")


def _table(head: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    top = "".join(f"<th>{html.escape(h)}</th>" for h in head)
    body = "".join(
        "<tr>" + "".join(f"<td>{html.escape(str(c))}</td>" for c in row) + "</tr>" for row in rows
    )
    return f"<table><thead><tr>{top}</tr></thead><tbody>{body}</tbody></table>"


def _width(parameter: Mapping[str, Any]) -> str:
    half = parameter["half_width"]
    return "anything (these data do not show it)" if half is None else _g(half)


def _g(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"
