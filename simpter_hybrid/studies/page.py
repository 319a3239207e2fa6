"""Studies as pages with pictures, as Markdown, and as text for a terminal."""

from __future__ import annotations

import base64
import html
from collections.abc import Mapping
from pathlib import Path

from ..files.json_text import json_text
from .study import Study, Table

STYLE = """body{font:15px/1.45 system-ui,sans-serif;color:#222;max-width:1100px;margin:2em auto;
padding:0 1em}table{border-collapse:collapse;margin:.5em 0 2em}td,th{border-top:1px solid #ddd;
padding:.3em .6em;text-align:left;vertical-align:top}th{font-weight:600}caption{text-align:left;
font-weight:600;padding:.3em 0}small{color:#555}img{max-width:100%}"""
COMMAND = "simpter study"
#: How to read every study, above all of them.
ABOUT = (
    "The thesis leaves some questions for later work. Each section below takes one of them and",
    "answers it with simulated runs: first what the runs show, then a picture, what was run, and",
    "the numbers.",
    "",
    "How to read the numbers:",
    "",
    "- Lengths are in inches and torques in lb-in, as in the thesis.",
    "- The error is the distance of the tip from the desired line, averaged along the path.",
    "- The jerk is the average rate at which the tip's acceleration changes. It is computed from",
    "  instants that are 2 ms apart (5 ms in the comparisons with the thesis, 1 ms in",
    "  `simpter run`). Where a clutch chatters, that is, quickly sticks and slips in turn, this",
    "  average grows as the step gets shorter.",
    "- Stops and breakaways count how often a clutch comes to rest or starts to slip.",
    "- Nominal inputs are one value for each quantity of a run: the printed one or, where the",
    "  thesis prints none, an inferred one. Plausible inputs are drawn from the ranges in which",
    "  the unprinted values may lie.",
    "- A ratio compares a variant with its reference, with the same inputs; below one, the variant",
    "  has less error or jerk. A share says for how many sets of plausible inputs it has less.",
    "- Runs in which clutches chatter amplify rounding errors. With another version of the program",
    "  or on another machine, a single number of such a run may differ by some per cent; medians",
    "  differ by less.",
)


def write_pages(studies: Mapping[str, Study], directory: str | Path, size: int | None) -> Path:
    """Write a page a study, ``index.html``, ``studies.md``, ``numbers.json``; returns the index.

    Parameters
    ----------
    studies : mapping of str to Study
    directory : str or path
        Made if it is not there.
    size : int or None
        As the studies were run, for the command that the pages name.
    """
    from ..plots.style import png

    folder = Path(directory)
    folder.mkdir(parents=True, exist_ok=True)
    for name, study in studies.items():
        picture = png(study.picture()) if study.picture else None
        write(folder / f"{name}.html", document(study.title, body(name, study, picture, size)))
        if picture is not None:
            (folder / f"{name}.png").write_bytes(picture)
        for file, text in study.files.items():
            write(folder / file, text)
    numbers = {name: study.numbers for name, study in studies.items()}
    write(folder / "numbers.json", json_text(numbers))
    write(folder / "studies.md", markdown(studies, size))
    links = "".join(
        f"<h2><a href='{name}.html'>{html.escape(study.title)}</a></h2><ul>"
        + "".join(f"<li>{html.escape(words)}</li>" for words in study.findings)
        + "</ul>"
        for name, study in studies.items()
    )
    index = folder / "index.html"
    write(index, document("What the thesis leaves for later", links))
    return index


def write(path: Path, text: str) -> None:
    """Text as UTF-8 with line ends alike everywhere."""
    path.write_text(text, encoding="utf-8", newline="\n")


def command(name: str, size: int | None) -> str:
    """The command that makes a page."""
    return f"{COMMAND} {name}" + ("" if size is None else f" --size {size}")


def document(title: str, inside: str) -> str:
    """A page that needs no network."""
    return (
        "<!doctype html><html lang='en'><meta charset='utf-8'>"
        f"<title>{html.escape(title)}</title><style>{STYLE}</style>"
        f"<h1>{html.escape(title)}</h1>{inside}</html>\n"
    )


def body(name: str, study: Study, picture: bytes | None, size: int | None) -> str:
    """What stands under a study's heading."""
    parts = [f"<p><small>{html.escape(study.source)}</small></p>"]
    parts.append("<ul>" + "".join(f"<li>{html.escape(f)}</li>" for f in study.findings) + "</ul>")
    if picture is not None:
        data = base64.b64encode(picture).decode("ascii")
        caption = html.escape(study.caption, quote=True)
        parts.append(
            f"<figure><img alt='{caption}' src='data:image/png;base64,{data}'>"
            f"<figcaption>{caption}</figcaption></figure>"
        )
    parts += [html_table(table) for table in study.tables]
    parts.append(f"<p>{html.escape(study.setup)}</p>")
    parts.append(f"<p><small>Made by <code>{command(name, size)}</code>.</small></p>")
    return "\n".join(parts)


def html_table(table: Table) -> str:
    """A table of a page."""
    head = "".join(f"<th>{html.escape(c)}" for c in table.columns)
    rows = "".join(
        "<tr>" + "".join(f"<td>{html.escape(c)}" for c in row) + "</tr>" for row in table.rows
    )
    return f"<table><caption>{html.escape(table.caption)}</caption><tr>{head}</tr>{rows}</table>"


def markdown(
    studies: Mapping[str, Study], size: int | None, pictures: str = "", made: str = ""
) -> str:
    """All studies as one Markdown file.

    Parameters
    ----------
    studies : mapping of str to Study
    size : int or None
        As the studies were run.
    pictures : str
        What stands before the pictures' file names, e.g. ``"studies/"``.
    made : str
        The command that made the page; that of ``write_pages`` if left out.
    """
    made = made or f"{COMMAND}{'' if size is None else f' --size {size}'} --out DIR"
    lines = ["# What the thesis leaves for later", "", f"Made by `{made}`.", "", *ABOUT, ""]
    for name, study in studies.items():
        lines += [f"## {study.title}", "", f"`{command(name, size)}` ({study.source})", ""]
        lines += section(study, f"{pictures}{name}.png")
    return "\n".join(lines)


def section(study: Study, picture: str) -> list[str]:
    """Findings, picture, set-up and tables of one study as lines of Markdown."""
    lines = ["What the runs show:", "", *(f"- {words}" for words in study.findings)]
    if study.picture:
        lines += ["", f"![{study.caption}]({picture})", "", study.caption]
    lines += ["", f"What was run: {study.setup}", ""]
    for table in study.tables:
        lines += table_lines(table)
    return lines


def table_lines(table: Table) -> list[str]:
    """A table under its caption as lines of Markdown."""
    head = ["| " + " | ".join(table.columns) + " |", "|" + "---|" * len(table.columns)]
    rows = ["| " + " | ".join(row) + " |" for row in table.rows]
    return [f"{table.caption}:", "", *head, *rows, ""]


def as_text(name: str, study: Study) -> str:
    """A study for a terminal."""
    lines = [f"{name}: {study.title}"]
    for table in study.tables:
        cells = [table.columns, *table.rows]
        widths = [max(len(row[k]) for row in cells) for k in range(len(table.columns))]
        lines += ["", f"  {table.caption}"]
        lines += [
            "  " + "  ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)).rstrip()
            for row in cells
        ]
    lines += ["", *(f"  - {words}" for words in study.findings), ""]
    return "\n".join(lines)
