"""The text of a clutch: its signals, its torque maps and its excitation, changed by effects."""

from __future__ import annotations

from ..clutch import Clutch
from ..device import Device
from ..effect import Effect
from ..part import arguments_of
from .model import SINGLE, Assembly, WiringError

#: Clutch ports, and the name of the value each receives.
CHAINS = {
    "slip_torque": "torque",
    "break_torque": "torque",
    "effective_excitation": "excitation",
    "excitation_rate": "rate",
    "seen_command": "command",
}


class ClutchText:
    """Writes what belongs to one clutch; ``ModelText`` puts it together."""

    device: Device
    clutches: tuple[Clutch, ...]
    effects: tuple[Effect, ...]
    a: Assembly
    laws: list[tuple[dict[str, str], dict[str, str]]]
    names: list[str]
    own: list[dict[str, str]]

    def on(self, port: str, clutch: int = -1, coordinate: int = -1) -> list[int]:
        """Numbers of the effects that change ``port`` of a clutch or a coordinate."""
        return [
            k
            for k, e in enumerate(self.effects)
            if port in e.functions()
            and (0 <= clutch == e.clutch or 0 <= coordinate == e.coordinate)
        ]

    def signals(self, i: int) -> dict[str, str]:
        """Names a function on clutch ``i`` may ask for, whatever it is for."""
        n = self.device.n
        angle = " + ".join(f"C[{i * n + j}] * y[{j}]" for j in range(n))
        return self.a.common() | {
            "excitation": f"y[{2 * n + i}]",
            "effective": f"x{i}",
            "slip": f"w{i}",
            "speed": "speed",
            "direction": "direction",
            "command": f"held[{i}]",
            "told_command": f"held[{i}]",
            "angle": f"({angle})",
        }

    def transmitted(self, i: int) -> dict[str, str]:
        """Names that only torques may ask for besides: where those are found, forces are known."""
        n = self.device.n
        applied, own = (
            " + ".join(f"C[{i * n + j}] * Q[{block * n + j}]" for j in range(n)) for block in (0, 2)
        )
        found = {"applied": f"({applied})", "conservative": f"({own})"}
        if n == self.device.m == 1:
            found |= {"net": "(f[0] / C[0])", "mass": "(M[0] / (C[0] * C[0]))"}
        return found

    def chain(self, port: str, start: str, i: int, provides: dict[str, str]) -> str:
        """``start`` passed through every effect on a port of clutch ``i``.

        Raises
        ------
        WiringError
            If an effect that has to be the last on its port is not.
        """
        value = start
        chained = self.on(port, clutch=i)
        for k in chained:
            if k != chained[-1] and closes_loop(self.effects[k], port):
                after = ", ".join(type(self.effects[j]).__name__ for j in chained if j > k)
                raise WiringError(
                    f"{type(self.effects[k]).__name__}.{port} solves for the whole friction of "
                    f"clutch {i + 1} and must be the last effect on its {port.replace('_', ' ')}; "
                    f"{after} comes after it"
                )
            given = provides | self.own[k] | {CHAINS[port]: value}
            value = self.a.call(self.effects[k], self.names[k], port, given)
        return value

    def slip_lines(self, i: int) -> list[str]:
        n = self.device.n
        slip = " + ".join(f"C[{i * n + j}] * y[{n + j}]" for j in range(n))
        shifted = self.chain("effective_excitation", f"y[{2 * n + i}]", i, self.signals(i))
        return [f"w{i} = {slip}", f"x{i} = {shifted}"]

    def friction(self, i: int) -> list[str]:
        """Friction torques of clutch ``i``: slip now; or breakaway and slip at 0+, both ways."""
        m = self.device.m
        given = self.signals(i) | self.transmitted(i)
        slip, brk = self.law_texts(i)
        for k in self.on("bristle_torque", clutch=i):
            call = self.a.call(
                self.effects[k], self.names[k], "bristle_torque",
                given | self.own[k]
                | {"level": "level", "breakaway": "breakaway", "dmode": "dmode"},
            )  # fmt: skip
            return [
                f"if mode[{i}] != 2:",
                *("    " + line for line in [*self.slip_lines(i), *self.levels(i, slip, brk)]),
                f"    fr[{i}] = {call}",
                *(f"    fr[{block * m + i}] = level" for block in (3, 4)),
                *(f"    fr[{block * m + i}] = breakaway" for block in (1, 2)),
            ]
        return [
            f"if mode[{i}] != 2:",
            *("    " + line for line in self.slip_lines(i)),
            f"    if mode[{i}] != 0:",
            f"        direction = float(mode[{i}])",
            f"        speed = direction * w{i}",
            f"        fr[{i}] = {slip}",
            "    else:",
            "        speed = 0.0",
            f"        fr[{i}] = 0.0",
            "        direction = 1.0",
            f"        fr[{3 * m + i}] = {slip}",
            f"        fr[{m + i}] = max({brk}, fr[{3 * m + i}])",
            "        direction = -1.0",
            f"        fr[{4 * m + i}] = {slip}",
            f"        fr[{2 * m + i}] = max({brk}, fr[{4 * m + i}])",
        ]

    def levels(self, i: int, slip: str, brk: str) -> list[str]:
        """What friction tends to in steady sliding, and the most it can be (bristle models)."""
        return [
            f"direction = {self.facing(i)}",
            f"speed = abs(w{i})",
            f"level = {slip}",
            f"breakaway = max({brk}, level)",
        ]

    def facing(self, i: int) -> str:
        """Expression for the direction of a clutch's friction: that of its slip, or its bristles'.

        Friction that differs between directions would jump where the slip of a wound bristle
        passes zero: that of the side to which the bristle bears changes where it bears nothing.
        """
        turned = f"w{i}"
        for k in self.on("bristle_side", clutch=i):
            given = self.signals(i) | self.own[k] | {"dmode": "dmode"}
            turned = self.a.call(self.effects[k], self.names[k], "bristle_side", given)
        return f"(1.0 if {turned} > 0.0 else -1.0)"

    def law_texts(self, i: int) -> tuple[str, str]:
        """Expressions for the slip and breakaway torque of clutch ``i``, effects included."""
        law, (_, own) = self.clutches[i].torque, self.laws[i]
        name, given = f"clutch.{i + 1}.torque", self.signals(i) | self.transmitted(i)
        lawful = given | own | {"excitation": f"x{i}"}
        slip = self.chain("slip_torque", self.a.call(law, name, "slip_torque", lawful), i, given)
        brk = self.chain("break_torque", self.a.call(law, name, "break_torque", lawful), i, given)
        return slip, brk

    def law_now(self, i: int) -> list[str]:
        """The torque map of clutch ``i`` as names for the rates of a bristle's states.

        Raises
        ------
        WiringError
            If the friction of the clutch depends on the torque that it transmits.
        """
        slip, brk = self.law_texts(i)
        if any(each in slip + brk for each in self.transmitted(i).values()):
            raise WiringError(
                f"clutch {i + 1}: friction by transmitted torque and a model of presliding "
                f"({type(self.effects[self.on('bristle_torque', clutch=i)[0]]).__name__}) do not "
                "go together; take one of the two effects away"
            )
        return [f"level{i} = {slip}", f"breakaway{i} = max({brk}, level{i})"]

    def index(self, name: str) -> int:
        return self.a.names.index(name)

    def excitation_texts(self, i: int) -> tuple[str, str]:
        """Expressions for the command that clutch ``i`` sees and its excitation's rate.

        The rate's expression uses the name ``command``.
        """
        given = self.signals(i) | self.laws[i][0]
        command = self.chain("seen_command", f"held[{i}]", i, given)
        given = given | {"command": "command"}
        lag = f"p[{self.index(f'clutch.{i + 1}.time_constant')}]"
        prompt = self.clutches[i].time_constant == 0.0
        rate = "0.0" if prompt else f"(command - y[{2 * self.device.n + i}]) / {lag}"
        return command, self.chain("excitation_rate", rate, i, given)

    def rate_lines(self, k: int) -> list[str]:
        """Lines that compute what guards of effect ``k`` ask for: ``rate``, ``slip``, levels."""
        effect, i = self.effects[k], self.effects[k].clutch
        functions = effect.functions()
        asked = {a for g in effect.guards for a in arguments_of(functions[f"{g}_guard"])}
        levels = self.law_now(i) if asked & {"level", "breakaway"} else []
        if not (asked & {"rate", "slip"} or levels):
            return []
        command, rate = self.excitation_texts(i)
        return [
            f"C = s[0:{self.device.m * self.device.n}]",
            "device_clutch_map(y, p, C)",
            *self.slip_lines(i),
            f"direction = {self.facing(i)}",
            f"speed = abs(w{i})",
            *levels,
            f"command = {command}",
            f"rate = {rate}",
        ]


def closes_loop(effect: Effect, port: str) -> bool:
    """Whether an effect asks for what friction itself changes: the acceleration."""
    return any(name in SINGLE for name in arguments_of(effect.functions()[port]))
