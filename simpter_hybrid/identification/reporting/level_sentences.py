"""What is said of a parameter that differs from run to run."""

from __future__ import annotations

from collections.abc import Sequence

from ..going_with import (
    ORDER,
    goes_with,
    may_go_with,
    split_by,
    sure_from,
    unasked,
)
from ..levels_with_speed import goes_with_speed
from ..order_of_kinds import order_of_kinds
from ..run_levels import (
    FEWEST,
    RunLevels,
    differs,
    odd_run,
    same_in_all,
    step_of,
    together,
)


def levels_text(found: Sequence[RunLevels], floor: float) -> str:
    """Words on the own values of one or several parameters: what they are and do."""
    sized = [f"{levels.parameter} ({_size(levels)})" for levels in found]
    last = found[-1]
    if len(found) == 1 and same_in_all(last):
        return (
            f"{last.parameter} of {last.usual:.3g} times what is declared, in every run alike, "
            f"takes away {100 * max(last.share, 0.0):.0f} % of what is left in windows that were "
            "not fitted: it may be known less well than its tolerance says"
        )
    if not all(map(differs, found)):
        part = f"{100 * max(last.share, 0.0):.0f} %"
        return (
            f"A value of its own for {' and '.join(sized)} in each run takes away {part} of "
            "what is left, and so is not all that is missing"
        )
    if len(found) == 1:
        fall = f"from {last.before / floor:.2f} to {last.after / floor:.2f} times the floor"
        return (
            f"{last.parameter} differs from run to run ({_size(last)}): with a value of its own in "
            f"each the error of windows that were not fitted falls {fall}"
        )
    alike = (
        "; they rise and fall together, as they do where the gain of the drive, its supply or the "
        "gain of a force sensor differs from run to run"
    )
    return (
        f"{' and '.join(sized)} differ from run to run: with values of their own in each the error "
        f"of windows that were not fitted falls to {last.after / floor:.2f} times the floor"
        f"{alike if together(found) else ''}"
    )


def _size(levels: RunLevels) -> str:
    times = [level for _, level in levels.levels]
    if odd := odd_run(levels):
        rest = [level for run, level in levels.levels if run != odd]
        return (
            f"{dict(levels.levels)[odd]:.4g} of its median in {odd}, {min(rest):.4g} to "
            f"{max(rest):.4g} in all others: is that run of the same rig?"
            f"{_course(levels)}"
        )
    return f"{min(times):.4g} to {max(times):.4g} of its median{_course(levels)}"


def _course(levels: RunLevels) -> str:
    said, runs, split = [], len(levels.levels), split_by(levels)
    sure = goes_with(levels)
    for name, tau in sure.items():
        way, channel = "rises" if tau > 0.0 else "falls", name.replace("_", " ")
        order = f"{way} in the {ORDER}, as what warms up or wears does"
        said.append(order if name == ORDER else f"{way} with {channel}, which was logged")
    if split:
        said = [_follows(name, split[name], name in sure, runs) for name in split]
    elif (step := step_of(levels)) is not None:
        within = f", in {step.between}," if step.between else ""
        said = [
            f"changes once{within} from {step.before:.4g} up to {step.until} to {step.after:.4g} "
            f"from {step.onwards} on: what happened there"
        ]
    if not said:
        for name, tau in may_go_with(levels).items():
            way, channel = "rises" if tau > 0.0 else "falls", name.replace("_", " ")
            said.append(
                f"{way} with {channel} in all {runs} runs ({sure_from(levels)} would be sure)"
            )
    if moved := goes_with_speed(levels):
        way = "rises" if moved.tau > 0.0 else "falls"
        seldom = _seldom(moved.chance)
        where = " among the pieces of each run" if moved.pieces else ""
        what = f"how fast a {'piece' if moved.pieces else 'run'} moves{where} ({seldom})"
        said.append(f"{way} with {what}, as what depends on speed does")
    if ORDER not in sure and (kinds := order_of_kinds(levels)):
        said.append(
            f"{'rises' if kinds.tau > 0.0 else 'falls'} on the whole in the order of the runs "
            f"within each repetition (Kendall's {abs(kinds.tau):.2f}, {_seldom(kinds.chance)}), "
            "as what warms up or wears does"
        )
    return (f"; it {' and '.join(said)}" if said else "") + _unasked(levels)


def _seldom(chance: float) -> str:
    return f"chance does so in {max(1, round(100 * chance))} of 100"


def _follows(name: str, chance: float, sure: bool, runs: int) -> str:
    """Words on a channel of few levels, at each of which the values are alike."""
    seldom = "" if sure else f" ({_seldom(chance)})"
    return f"follows {name.replace('_', ' ')}, which was logged, in all {runs} runs{seldom}"


def _unasked(levels: RunLevels) -> str:
    """Words on logged channels that so few runs cannot be asked for; else ""."""
    if not (names := unasked(levels)):
        return ""
    channel = names[0].replace("_", " ") if len(names) == 1 else "a logged channel"
    sure = f"{sure_from(levels)} would be sure"
    return f"; whether it goes with {channel} is asked of {FEWEST} runs and more ({sure})"
