"""One page of all comparisons: printed value, what comes out here, verdict, and pictures."""

from __future__ import annotations

import base64
import html
import json
from collections import Counter
from collections.abc import Mapping
from pathlib import Path

from .registry import REPRODUCTIONS
from .rows import FAILS, HOLDS, UNCOMPARABLE, Row, plain

STYLE = """body{font:15px/1.45 system-ui,sans-serif;color:#222;max-width:1100px;margin:2em auto;
padding:0 1em}table{border-collapse:collapse;width:100%;margin:.5em 0 2em}td,th{border-top:1px solid
#ddd;padding:.35em .5em;text-align:left;vertical-align:top}th{font-weight:600}.holds{color:#00614a}
.fails{color:#a63c00}.open{color:#555}small{color:#555}img{max-width:100%}"""
CLASSES = {HOLDS: "holds", FAILS: "fails", UNCOMPARABLE: "open"}
LEAD = """About a dozen inputs of chapter 5 are not printed and were inferred from its own tables
and figures: that numbers of Tables 5 and 6 come close validates nothing. What is judged is every
ordering and every statement, at the nominal inputs and over inputs drawn from their plausible
ranges; the share says for how many of them a claim holds. A claim that fails is a finding."""


def write_page(
    comparisons: Mapping[str, list[Row]],
    directory: str | Path,
    pictures: Mapping[str, tuple[str, bytes]] | None = None,
) -> Path:
    """Write ``index.html`` and ``rows.json``; returns the page's path.

    Parameters
    ----------
    comparisons : mapping of str to list of Row
    directory : str or path
        Made if it is not there.
    pictures : mapping of str to (str, bytes), optional
        By name of the comparison: a caption and a PNG file.
    """
    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    data = {name: [row.as_dict() for row in rows] for name, rows in comparisons.items()}
    (folder / "rows.json").write_text(
        json.dumps(data, indent=1, default=plain) + "\n", encoding="utf-8"
    )
    page = folder / "index.html"
    page.write_text(render(comparisons, pictures or {}), encoding="utf-8")
    return page


def render(comparisons: Mapping[str, list[Row]], pictures: Mapping[str, tuple[str, bytes]]) -> str:
    """The page's text."""
    counts = Counter(row.verdict for rows in comparisons.values() for row in rows)
    total = ", ".join(f"{counts[v]} {v}" for v in (HOLDS, FAILS, UNCOMPARABLE))
    body = [f"<h1>The thesis's results side by side</h1><p>{LEAD}</p><p><b>{total}.</b></p>"]
    for name, rows in comparisons.items():
        body.append(f"<h2 id='{name}'>{name}</h2><p>{html.escape(REPRODUCTIONS[name][1])}</p>")
        body.append("<table><tr><th>claim<th>printed<th>here<th>verdict</tr>")
        body += [line_of(row) for row in rows]
        body.append("</table>")
        if name in pictures:
            caption, png = pictures[name]
            data = base64.b64encode(png).decode("ascii")
            body.append(
                f"<figure><img alt='{html.escape(caption, quote=True)}' "
                f"src='data:image/png;base64,{data}'><figcaption>{html.escape(caption)}"
                "</figcaption></figure>"
            )
    head = (
        "<!doctype html><html lang='en'><meta charset='utf-8'>"
        f"<title>The thesis side by side</title><style>{STYLE}</style>"
    )
    return head + "\n".join(body) + "</html>\n"


def line_of(row: Row) -> str:
    """One row of the table."""
    share = "" if row.share is None else f" ({100 * row.share:.0f} % of plausible inputs)"
    why = f"<br><small>{html.escape(row.why)}</small>" if row.why else ""
    return (
        f"<tr><td>{html.escape(row.claim)}<br><small>{row.item}</small><td>"
        f"{html.escape(row.printed)}<td>{html.escape(row.ours)}{why}<td class='"
        f"{CLASSES[row.verdict]}'>{row.verdict}{share}</tr>"
    )


def as_text(name: str, rows: list[Row]) -> str:
    """The rows for a terminal."""
    lines = [f"{name}: {REPRODUCTIONS[name][1]}"]
    for row in rows:
        share = "" if row.share is None else f", {100 * row.share:.0f} % of plausible inputs"
        lines.append(f"  {row.verdict.upper()}{share}: {row.claim} [{row.item}]")
        lines.append(f"      printed: {row.printed}")
        lines.append(f"      here:    {row.ours}")
        if row.why:
            lines.append(f"      {row.why}")
    return "\n".join(lines)
