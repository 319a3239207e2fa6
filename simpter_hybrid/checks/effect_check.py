"""Whether effects act on something, have all their functions, and do not undo each other."""

from __future__ import annotations

from ..effect import Effect
from ..effects.drive_released import DriveReleased
from ..loads.drive import VoltageDrive
from ..problems import Problems
from ..scenario import Scenario
from .angle_check import check_angles

#: What an effect may change of a clutch and of a coordinate.
CLUTCH_PORTS = (
    "slip_torque", "break_torque", "effective_excitation", "excitation_rate", "seen_command",
    "bristle_torque",
)  # fmt: skip
COORDINATE_PORTS = ("force", "inertia")
#: Ports between a command and the excitation that lags behind it.
LAG_PORTS = ("excitation_rate", "seen_command")


def place_of(effect: Effect | type[Effect]) -> str:
    """``clutch`` or ``coordinate``: what an effect acts on; "" where it changes nothing."""
    cls = effect if isinstance(effect, type) else type(effect)
    names = {name for c in cls.__mro__ for name in vars(c)}
    if names & set(COORDINATE_PORTS):
        return "coordinate"
    replaced = (cls.changed_delay, cls.changed_threshold)
    plain = (Effect.changed_delay, Effect.changed_threshold)
    return "clutch" if names & set(CLUTCH_PORTS) or replaced != plain else ""


def check_effects(s: Scenario, problems: Problems) -> None:
    """Record what is wrong with the effects of a scenario, and maps by an angle that is none."""
    for k, effect in enumerate(s.effects):
        name, place = type(effect).__name__, place_of(effect)
        if not place:
            ports = ", ".join((*CLUTCH_PORTS, *COORDINATE_PORTS))
            problems.add(("effects", k), "it changes nothing", name, f"one of {ports}")
            continue
        count = s.device.m if place == "clutch" else s.device.n
        at = getattr(effect, place)
        if not 0 <= at < count:
            right = f"a {place} from 0 to {count - 1}, as counted in Python"
            problems.add(("effects", k, place), f"no such {place}", at, right)
        for function in missing_functions(effect):
            right = f"a static function {function}(...) of {name}"
            problems.add(("effects", k), f"{function} is missing", name, right)
        for state in effect.settled:
            if state not in effect.states:
                problems.add(("effects", k), "settled names no state", state, "one of its states")
        check_together(s, k, problems)
        check_ends(s, k, problems)
        check_lag(s, k, problems)
    check_angles(s, problems)


def check_ends(s: Scenario, k: int, problems: Problems) -> None:
    """An effect on a motor's current, where a driver at times lets none flow."""
    effect = s.effects[k]
    for load in s.loads if effect.ends_closed else ():
        if not isinstance(load, VoltageDrive) or load.coordinate != effect.coordinate:
            continue
        if load.coasting > 0.0 and load.supply > 0.0:
            what = f"{type(effect).__name__} takes the ends of its motor for closed at all times"
            right = "coasting = 0 of the voltage-drive, or no such effect on it"
            problems.add(("effects", k), what, f"coasting = {load.coasting:g}", right)
    others = (o for o in s.effects if o is not effect and o.coordinate == effect.coordinate)
    if isinstance(effect, DriveReleased) and any(other.ends_closed for other in others):
        what = "it opens the ends of a motor that another effect takes for closed at all times"
        right = "one of the two alone"
        problems.add(("effects", k), what, "DriveReleased", right)


def check_lag(s: Scenario, k: int, problems: Problems) -> None:
    """An effect on what a clutch's excitation lags behind, where it is the command itself."""
    effect = s.effects[k]
    changed = [port for port in LAG_PORTS if port in effect.functions()]
    others = [port for port in CLUTCH_PORTS if port in effect.functions() and port not in changed]
    prompt = [i for i, clutch in enumerate(s.clutches) if clutch.time_constant == 0.0]
    if changed and not others and effect.clutch in prompt:
        what = f"clutch {effect.clutch + 1} has no lag: its excitation is the command that is told"
        right = f"a time_constant above 0, or no effect on its {changed[0].replace('_', ' ')}"
        problems.add(("effects", k), what, type(effect).__name__, right)


def missing_functions(effect: Effect) -> list[str]:
    """Functions that an effect's states and guards ask for and that it does not have."""
    asked = [f"{state}_rate" for state in effect.states]
    asked += [f"{guard}_{what}" for guard in effect.guards for what in ("guard", "jump")]
    return [name for name in asked if name not in effect.functions()]


def check_together(s: Scenario, k: int, problems: Problems) -> None:
    """An effect that takes no notice of those before it on the same clutch."""
    effect = s.effects[k]
    functions = effect.functions()
    ignored = {*effect.replaces, *({"bristle_torque"} & functions.keys())}
    for port in sorted(ignored):
        before = [
            type(e).__name__
            for e in s.effects[:k]
            if e.clutch == effect.clutch and port in e.functions()
        ]
        if before:
            alone = "one of them" if port == "bristle_torque" else "it before them"
            what = f"it replaces the {port.replace('_', ' ')} that {', '.join(before)} made"
            problems.add(("effects", k), what, type(effect).__name__, alone)
