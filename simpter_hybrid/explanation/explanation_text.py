"""The words of an explanation: what a user reads who asks why it slipped here."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import TYPE_CHECKING

from .facets import numbered

if TYPE_CHECKING:
    from .explain import Explanation
    from .facets import Facet
    from .successors import Round

#: Words for modes.
MODE_WORDS = {-1: "backward", 0: "stuck", 1: "forward", 2: "off"}
CONVENTION = (
    "{names} were stuck redundantly: how they shared the load is not determined. Where "
    "torques of theirs are shown, they follow a convention (least sum of (torque/breakaway "
    "torque)^2). The margins above and what followed do not depend on it."
)
GAUSS_RULE = (
    "Within such bounds the torques at zero slip are those whose acceleration is nearest to the "
    "free motion in kinetic energy (Gauss's principle)."
)
FACET_RULE = (
    "Breakaway torque and slip torque are equal here, so slip begins without acceleration: the "
    "broken facet says which clutches slip and which way."
)


def modes_in_words(mode: Sequence[int]) -> str:
    """``1 forward, 2 off, 3 stuck``."""
    return ", ".join(f"{i + 1} {MODE_WORDS.get(code, '-')}" for i, code in enumerate(mode))


def text_of(e: Explanation) -> str:
    """The whole text."""
    lines: list[str] = []
    if e.event is None:
        lines += [f"t = {e.t:.9g} s: the run has no events.", f"Modes: {modes_in_words(e.mode)}."]
        return "\n".join(lines + margin_table("Stick margins now", e.facets, e.unit))
    if e.asked != e.t:
        lines += [f"Nothing happens at t = {e.asked:.9g} s; the nearest event is explained below."]
        lines += [f"Modes at t = {e.asked:.9g} s: {modes_in_words(e.mode_now)}."]
        lines += [*margin_table("Stick margins then", e.now, e.unit), ""]
    lines += heading(e)
    lines += section("Why now", reason(e))
    if e.facets:
        lines += ["", *margin_table("Stick margins just before", e.facets, e.unit)]
    if e.undecided:
        if e.candidates:
            lines += ["", *candidate_table(e)]
        lines += section("Rule applied", rule(e))
    if e.redundant:
        names = numbered(e.redundant).capitalize()
        lines += section("Convention", [CONVENTION.format(names=names)])
    return "\n".join(lines)


def section(title: str, paragraphs: Sequence[str]) -> list[str]:
    """A titled block of paragraphs, wrapped; nothing without paragraphs."""
    if not paragraphs:
        return []
    lines = ["", title]
    for paragraph in paragraphs:
        lines += textwrap.wrap(paragraph, 98, initial_indent="  ", subsequent_indent="  ")
    return lines


def heading(e: Explanation) -> list[str]:
    """What happened and when, with the modes on both sides."""
    event = e.event
    assert event is not None
    head = f"t = {event.t:.9g} s: {event.kind}, {numbered(event.clutches)}"
    if event.case_before or event.case_after:
        head += f" (case {event.case_before or '-'} -> {event.case_after or '-'})"
    return [
        head,
        f"  before: {modes_in_words(event.before)}",
        f"  after:  {modes_in_words(event.after)}",
    ]


def reason(e: Explanation) -> list[str]:
    """Why the event happened at this instant."""
    event = e.event
    assert event is not None
    if event.kind == "breakaway" and e.facets:
        return breakaway_reason(e, e.facets[0])
    if event.kind == "slip stop":
        stopped = [i for i in event.clutches if event.before[i - 1] in (-1, 1)]
        return [f"The slip velocity of {numbered(stopped)} reached zero."]
    lines = []
    for i in event.clutches:
        if event.before[i - 1] == 2:
            lines.append(
                f"Clutch {i} was switched on: its command had been above the off threshold for the "
                "whole switch-on delay."
            )
        elif event.after[i - 1] == 2:
            lines.append(
                f"Clutch {i} was switched off: its command was at or below the off threshold and "
                "its excitation had fallen to it."
            )
    return lines


def breakaway_reason(e: Explanation, facet: Facet) -> list[str]:
    """What was needed, what was available, and which of the two moved."""
    parts = [(i + 1, share) for i, share in enumerate(facet.pattern) if share > 0.0]
    if len(parts) == 1:
        asked = f"Holding clutch {parts[0][0]} took"
    else:
        terms = " + ".join(f"{'' if s == 1.0 else f'{s:.4g} '}tau_{i}" for i, s in parts)
        asked = f"The first to give in are {facet.name} together. Holding them took, as {terms},"
    volts = ", ".join(f"clutch {i} at {e.excitation[i - 1]:.4g} V" for i, _ in parts)
    who = "it" if len(parts) == 1 else "they"
    lines = [
        f"{asked} {facet.needed:.6g} {e.unit}; {who} can give {facet.available:.6g} {e.unit} "
        f"({volts})."
    ]
    lines.append(
        f"Just before, what was needed changed at {facet.needed_rate:+.4g} {e.unit}/s and what was "
        f"available at {facet.available_rate:+.4g} {e.unit}/s: {mover(facet)}."
    )
    return lines


def mover(facet: Facet) -> str:
    """Which side of the margin brought it down."""
    if facet.needed_rate > 0.0 and facet.available_rate < 0.0:
        larger = facet.needed_rate > -facet.available_rate
        return "the load rose and the clutch weakened, " + (
            "the load more" if larger else "the clutch more"
        )
    if facet.available_rate < 0.0:
        if facet.excitation_fell:
            return "the clutch weakened (its excitation was falling)"
        return "the clutch weakened, though its excitation did not fall"
    if facet.needed_rate > 0.0:
        return "the load rose"
    return "the limit was passed at the start of the segment (an input jumped)"


def margin_table(title: str, facets: Sequence[Facet], unit: str) -> list[str]:
    """Torque needed, available, and the margin of every facet."""
    if not facets:
        return [title + ": nothing was stuck."]
    title += f" [{unit}]"
    width = max([len(title), *(len(f.name) + 2 for f in facets)])
    rows = [f"{title:{width}}{'needed':>12}{'available':>12}{'margin':>12}"]
    for f in facets:
        rows.append(f"{'  ' + f.name:{width}}{f.needed:12.6g}{f.available:12.6g}{f.margin:12.3g}")
    return rows


def candidate_table(e: Explanation) -> list[str]:
    """Every successor tried, with what speaks for or against it."""
    assert e.event is not None
    zero = e.rounds[0].zero
    rows = [f"What could follow ({numbered(zero)} at zero slip, {len(e.candidates)} combinations)"]
    refused = 0
    for c in e.candidates:
        taken = c.mode == e.event.after
        if c.verdict == "refused" and not taken and len(e.candidates) > 9:
            refused += 1
            continue
        words = ", ".join(f"{i} {MODE_WORDS[c.mode[i - 1]]}" for i in zero)
        more = f": {c.reason}" if c.reason else ""
        line = f"{'->' if taken else '  '} {words}: {c.verdict}{more}"
        rows += textwrap.wrap(line, 98, subsequent_indent="       ", drop_whitespace=False)
    if refused:
        rows.append(f"  ... and {refused} that the equations of motion refuse")
    if e.others:
        rows.append(f"  AMBIGUOUS: {len(e.others)} other(s) would have been consistent as well.")
    return rows


def rule(e: Explanation) -> list[str]:
    """How the successor was found, round by round."""
    lines = []
    for number, step in enumerate(e.rounds, 1):
        lead = f"Round {number}: " if len(e.rounds) > 1 else ""
        lines.append(lead + (FACET_RULE if step.by_facet else bounds(step) + GAUSS_RULE))
        if step.let_go and not step.by_facet:
            lines.append(
                f"There {numbered(step.let_go)} would slip: bounded by the slip torque from then "
                "on, and the problem solved again."
            )
        if step.least_margin < 0.0:
            lines.append(
                f"Found {modes_in_words(step.after)}, but its least margin is "
                f"{step.least_margin:.4g} {e.unit}: that facet breaks in turn."
            )
    last = e.rounds[-1].after
    if e.in_turn:
        lines.append("That was the first of several that broke away at this instant, in turn.")
    elif e.event is not None and last != e.event.after:
        lines.append(f"Replaying the rule gives {modes_in_words(last)}; the run took another mode.")
    return lines


def bounds(step: Round) -> str:
    """Who may hold up to what."""
    released = tuple(i for i in step.zero if i not in step.may_hold)
    parts = []
    if step.may_hold:
        parts.append(f"{numbered(step.may_hold)} may hold up to the breakaway torque.".capitalize())
    if released:
        parts.append(
            f"{numbered(released).capitalize()}, just broken away, may not hold again at this "
            "instant: the slip torque at 0+ is the bound."
        )
    return " ".join(parts) + " "
