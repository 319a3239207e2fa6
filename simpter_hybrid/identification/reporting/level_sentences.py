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
            f"{last.parameter} of {_usual(last)}, in every run alike, "
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
            f"each the error of windows that were not fitted falls {fall}{_asks(last)}"
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


def _asks(levels: RunLevels) -> str:
    """What may have given each run a zero of its own; "" of what is no zero."""
    return ", as where the sensor was zeroed anew before each run" if levels.step else ""


def _size(levels: RunLevels) -> str:
    times = [level for _, level in levels.levels]
    if odd := odd_run(levels):
        rest = [level for run, level in levels.levels if run != odd]
        return (
            f"{_about(levels, dict(levels.levels)[odd])} in {odd}, {_value(levels, min(rest))} to "
            f"{_value(levels, max(rest))} in all others: is that run of the same rig?"
            f"{_course(levels)}{_ended(levels)}"
        )
    spread = f"{_value(levels, min(times))} to {_about(levels, max(times))}"
    return f"{spread}{_course(levels)}{_ended(levels)}"


def _value(levels: RunLevels, level: float) -> str:
    return f"{level * levels.step:+.3g}" if levels.step else f"{level:.4g}"


def _about(levels: RunLevels, level: float) -> str:
    """The value of a run, and what it is counted from and in."""
    if not levels.step:
        return f"{_value(levels, level)} of its median"
    return f"{_value(levels, level)} {_unit(levels)} from its median"


def counted(levels: RunLevels) -> str:
    """What the value of a run is counted from, as the head of its column says it."""
    over = "over the median of the runs"
    return f"{_unit(levels)} above the median of the runs" if levels.step else over


def _unit(levels: RunLevels) -> str:
    return "times what is declared" if levels.unit == "1" else levels.unit


def _usual(levels: RunLevels) -> str:
    """The median of values that are the same in all runs."""
    if not levels.step or levels.unit == "1":
        median = 1.0 + (levels.usual - 1.0) * levels.step if levels.step else levels.usual
        return f"{median:.3g} times what is declared"
    return f"{(levels.usual - 1.0) * levels.step:+.3g} {levels.unit} beside what is declared"


def _ended(levels: RunLevels) -> str:
    """Words on runs whose values ended at a bound; "" without any."""
    if not levels.ended:
        return ""
    end = "ends" if len(levels.ended) == 1 else "end"
    return f"; {' and '.join(levels.ended)} {end} at the bound of what is tried"


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
            f"changes once{within} from {_value(levels, step.before)} up to {step.until} to "
            f"{_value(levels, step.after)} from {step.onwards} on: what happened there"
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
