"""What the thesis leaves open in its use of Karnopp's model, as named choices."""

from __future__ import annotations

from dataclasses import dataclass

LIMITERS = ("links", "clutches", "reset", "none")
SIGNS = ("printed", "both")
SATURATED = ("clip", "resolve")
CLOSEST = ("absolute", "relative")
CASES = ("table", "general")


@dataclass(frozen=True)
class Rules:
    """Choices of a Karnopp simulator.

    Parameters
    ----------
    limiter : str
        What the position integrator receives (thesis 3.2.4). ``links``: zero for every coordinate
        slower than the band, as the thesis prints it. ``clutches``: the speeds with the slip of
        every holding clutch taken out (least change), so that a link coupled to another does not
        drift and a free link that is merely slow still moves. ``reset``: the same, and at the end
        of a step the speeds themselves take that value, so that what is left of a slip when it is
        caught does not hide another clutch's rest; where that takes another clutch just out of the
        band, the two may be caught and let go in turn, thousands of times. ``none``: the speeds as
        they are.
    signs : str
        Special cases of Case 7. ``printed``: clutches at plus their breakaway torque only, as in
        (24)-(29). ``both``: plus and minus, with which "some feasible combination holds" is decided
        exactly.
    saturated : str
        Two stuck clutches of which one is overloaded (Cases 4 to 6). ``clip``: each torque is cut
        at its own breakaway level, the other still computed as if both held (the words of 3.2.3.4).
        ``resolve``: the other is computed again beside the saturated one, as in Cases 2 and 3.
    closest : str
        "Closest to breakaway" in Case 7: the ``absolute`` distance in torque, or ``relative`` to
        the breakaway torque.
    cases : str
        ``table``: Tables 1 and 2 with Appendix A, for PTER. ``general``: any n and m; every clutch
        inside the band sticks, its torques are those of least norm (each in
        units of its breakaway torque) that stop all slip
        acceleration, and overloaded clutches are set to their breakaway torque one at a time,
        worst first, and taken back if they would then drive. Devices other than PTER always use
        ``general``.
    """

    limiter: str = "links"
    signs: str = "both"
    saturated: str = "clip"
    closest: str = "absolute"
    cases: str = "table"

    def __post_init__(self) -> None:
        for name, allowed in (
            ("limiter", LIMITERS),
            ("signs", SIGNS),
            ("saturated", SATURATED),
            ("closest", CLOSEST),
            ("cases", CASES),
        ):
            if getattr(self, name) not in allowed:
                raise ValueError(
                    f"{name} = {getattr(self, name)!r} is not a Karnopp rule; "
                    f"choose one of {', '.join(allowed)}"
                )


#: As the thesis describes it; where its text and its printed signs differ, the text.
THESIS = Rules()
#: The same tables with every choice for the better.
FAIR = Rules(limiter="clutches", signs="both", saturated="resolve", closest="relative")
#: Without the tables: what somebody who tunes Karnopp by hand arrives at. Table 1 takes everything
#: to be at rest where two clutches are inside the band, and chatters on its edge; this does not.
TUNED = Rules(
    limiter="reset", signs="both", saturated="resolve", closest="relative", cases="general"
)
