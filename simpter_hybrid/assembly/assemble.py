"""The text of a model's functions, part by part."""

from __future__ import annotations

from ..applied_load import Load
from ..clutch import Clutch
from ..controller import Controller, held_side_by_side
from ..device import Device
from ..effect import Effect
from ..part import Part
from .clutch_text import ClutchText
from .model import Assembly, WiringError


class ModelText(ClutchText):
    """Writes the functions of one model; ``finish`` returns the text."""

    def __init__(
        self,
        device: Device,
        clutches: tuple[Clutch, ...],
        loads: tuple[Load, ...],
        controllers: tuple[tuple[Controller, int], ...],
        effects: tuple[Effect, ...],
        stops: tuple[Part, ...],
    ) -> None:
        self.device, self.clutches, self.effects = device, clutches, effects
        self.a = Assembly(device)
        self.a.add(device, "device")
        self.a.held = held_side_by_side(controller for controller, _ in controllers)
        self.laws = []
        self.pushes: list[str] = []
        for i, clutch in enumerate(clutches):
            own = self.a.add(clutch, f"clutch.{i + 1}")
            self.laws.append((own, self.a.add(clutch.torque, f"clutch.{i + 1}.torque")))
        self.names = [f"effect.{k + 1}.{type(e).__name__}" for k, e in enumerate(effects)]
        self.own: list[dict[str, str]] = []
        for effect, name in zip(effects, self.names, strict=True):
            own = self.a.add(effect, name)
            base = 2 * device.n + len(clutches)
            own["states_at"] = str(base + len(self.a.states))
            own["modes_at"] = str(self.a.modes)
            if effect.coordinate >= 0:
                own["coordinate"] = str(effect.coordinate)
            for state in effect.states:
                own[state] = f"y[{base + len(self.a.states)}]"
                self.a.states.append(f"{name}.{state}")
            self.a.modes += effect.modes
            self.own.append(own)
        self.map()
        self.terms(loads)
        self.rates()
        self.control(controllers)
        self.watch(stops)

    def finish(self) -> str:
        """The assembled module's text."""
        return self.a.text()

    def map(self) -> None:
        self.a.bodies["map"] = ["device_clutch_map(y, p, C)"]

    def terms(self, loads: tuple[Load, ...]) -> None:
        n, m = self.device.n, self.device.m
        body = [f"qd = y[{n}:{2 * n}]", "device_mass_matrix(y, p, M)", "device_clutch_map(y, p, C)"]
        if not self.device.constant_clutch_map:
            body.append("device_clutch_map_rate(y, qd, p, c)")
        body.append("device_velocity_terms(y, qd, p, f)")
        body += [f"Q[{j}] = 0.0" for j in range(3 * n)]
        for k, load in enumerate(loads):
            body += self.load(k, load)
        self.tip_force_now()
        if "conservative_force" in self.device.functions():
            body.append(f"part = s[0:{n}]")
            body.append("device_conservative_force(y, p, part)")
            body += [f"Q[{2 * n + j}] = part[{j}]" for j in range(n)]
        if "damping_force" in self.device.functions():
            body.append(f"part = s[0:{n}]")
            body.append("device_damping_force(y, qd, p, part)")
            body += [f"Q[{n + j}] += part[{j}]" for j in range(n)]
        for j in range(n):
            given = self.a.common() | {"position": f"y[{j}]", "speed": f"y[{n + j}]"}
            given["dmode"] = "dmode"
            for k in self.on("inertia", coordinate=j):
                call = self.a.call(self.effects[k], self.names[k], "inertia", given | self.own[k])
                body.append(f"M[{j * n + j}] += {call}")
            for k in self.on("force", coordinate=j):
                call = self.a.call(self.effects[k], self.names[k], "force", given | self.own[k])
                body.append(f"Q[{n + j}] += {call}")
        body += [f"f[{j}] = Q[{j}] + Q[{n + j}] + Q[{2 * n + j}] - f[{j}]" for j in range(n)]
        for i in range(m):
            body += self.friction(i)
        self.a.bodies["terms"] = body

    def load(self, k: int, load: Load) -> list[str]:
        """Lines of text that add what load ``k`` (from 0) exerts to ``Q``.

        Raises
        ------
        WiringError
            If the load pushes at the tip and the device has none.
        """
        n = self.device.n
        name = f"load.{k + 1}"
        own = self.a.add(load, name)
        if "force" in load.functions():
            return [self.a.call(load, name, "force", self.a.common() | own | {"Q": "Q"})]
        carried = "tip_inertia" in load.functions()
        for needed in ("tip_jacobian", "tip_jacobian_rate")[: 2 if carried else 1]:
            if needed not in self.device.functions():
                raise WiringError(
                    f"load {k + 1} ({type(load).__name__}) pushes at the tip, but "
                    f"{type(self.device).__name__} has no {needed}"
                )
        if carried:
            return self.carried(self.a.call(load, name, "tip_inertia", self.a.common() | own))
        call = self.a.call(load, name, "tip_force", self.a.common() | own | {"out": "push"})
        self.pushes.append(call)
        lines = ["push = s[0:2]", f"jac = s[2:{2 + 2 * n}]", call, "device_tip_jacobian(y, p, jac)"]
        return lines + [f"Q[{j}] += jac[{j}] * push[0] + jac[{n + j}] * push[1]" for j in range(n)]

    def carried(self, mass: str) -> list[str]:
        """A mass at the tip in the mass matrix and, while ``f`` holds them, in velocity terms."""
        n = self.device.n
        rows = [(f"jac[{j}]", f"jac[{n + j}]") for j in range(n)]
        lines = [f"jac = s[2:{2 + 2 * n}]", f"bend = s[{2 + 2 * n}:{4 + 2 * n}]"]
        lines += ["device_tip_jacobian(y, p, jac)", "device_tip_jacobian_rate(y, qd, p, bend)"]
        lines.append(f"carried = {mass}")
        for a, (x, y) in enumerate(rows):
            for b, (u, v) in enumerate(rows):
                lines.append(f"M[{a * n + b}] += carried * ({x} * {u} + {y} * {v})")
            lines.append(f"f[{a}] += carried * ({x} * bend[0] + {y} * bend[1])")
        return lines

    def tip_force_now(self) -> None:
        """A function that controllers may ask for: what a force sensor at the tip would read.

        ``tip_force_now(time, state, p, rec, held, s, out)`` sums all tip forces in ``out[0:2]``
        [N]; ``out`` (4,) must lie beyond ``s[0:2]``, which loads may scribble on.
        """
        lines = ["def tip_force_now(t, y, p, rec, held, s, out):", "out[0] = 0.0", "out[1] = 0.0"]
        for call in self.pushes:
            lines += ["push = out[2:4]", call, "out[0] += push[0]", "out[1] += push[1]"]
        self.a.sources["tip_force_now"] = "\n    ".join(lines) + "\n"

    def rates(self) -> None:
        n, m = self.device.n, self.device.m
        body: list[str] = []
        for i in range(m):
            if any(e.clutch == i for e in self.effects):
                body += self.slip_lines(i)
                body += [f"direction = {self.facing(i)}", f"speed = abs(w{i})"]
            command, rate = self.excitation_texts(i)
            if self.on("bristle_torque", clutch=i):
                body += self.law_now(i)
            body += [f"dy[{2 * n + i}] = 0.0", f"if gate[{i}] == 2:"]
            body += [f"    command = {command}", f"    dy[{2 * n + i}] = {rate}"]
        for k, effect in enumerate(self.effects):
            for state in effect.states:
                if effect.clutch >= 0:
                    i = effect.clutch
                    given = self.signals(i) | {"torque": f"tau[{i}]", "rate": f"dy[{2 * n + i}]"}
                    given |= {"engaged": f"(1.0 if gate[{i}] == 2 else 0.0)"}
                    given |= {"direction": f"(1.0 if w{i} > 0.0 else -1.0)", "speed": f"abs(w{i})"}
                    given |= {"level": f"level{i}", "breakaway": f"breakaway{i}", "dmode": "dmode"}
                else:
                    j = effect.coordinate
                    given = self.a.common() | {"position": f"y[{j}]", "speed": f"y[{n + j}]"}
                    given["dmode"] = "dmode"
                at = self.own[k][state][2:-1]
                call = self.a.call(effect, self.names[k], f"{state}_rate", given | self.own[k])
                body.append(f"dy[{at}] = {call}")
        self.a.bodies["rates"] = body

    def control(self, controllers: tuple[tuple[Controller, int], ...]) -> None:
        n = self.device.n
        body: list[str] = []
        back: list[list[str]] = []
        seen: dict[str, str] = {}
        for k, (controller, every) in enumerate(controllers):
            name = f"controller.{k + 1}"
            own = self.a.add(controller, name)
            given = self.a.common() | {"state": "y"} | own
            given |= {"k": f"k // {every}" if every > 1 else "k"}
            given |= {"tau": "tau", "mem": "mem", "mem_at": str(self.a.memory), "n": str(n)}
            given |= {"m": str(self.device.m), "tip_force_now": "tip_force_now"} | seen
            self.a.stages.append((given, self.a.memory))
            for word, at in controller.replaces.items():
                first = self.a.memory + at
                seen[word] = f"mem[{first}:{first + n}]"
            self.a.memory += len(controller.memory)
            call = self.a.call(controller, name, "step", given)
            lines = [f"if k % {every} == 0:", f"    {call}"] if every > 1 else [call]
            before = {earlier for _, earlier in controllers[:k]}
            inputs = self.rewritten(controller)
            if inputs and any(every % earlier != 0 for earlier in before):
                restored, lines = self.kept(inputs, every, before, call)
                back.append(restored)
            body += lines
        # The earliest stage's comes last: the stages that follow it are given what it leaves.
        self.a.bodies["control"] = [line for lines in reversed(back) for line in lines] + body

    def rewritten(self, controller: Controller) -> list[str]:
        """Held inputs that a stage reads and writes anew."""
        m = self.device.m
        found = [f"held[{i}]" for i in range(m) if "command" in controller.rewrites]
        names = [name.rsplit("_", 1)[0] for name in self.a.held]
        return found + [f"held[{m + i}]" for i, n in enumerate(names) if n in controller.rewrites]

    def kept(
        self, inputs: list[str], every: int, before: set[int], call: str
    ) -> tuple[list[str], list[str]]:
        """What a stage rewrites, kept as it was told and as it left it, where those before it wait.

        Where an earlier stage acts less often, the stage would find there what it left itself.  At
        every sample at which it or one before it acts what it was told stands there again (first
        lines), for the earlier ones to change; where it does not act itself, what it left is put
        back behind them (second lines, with its own).
        """
        first, count = self.a.memory, len(inputs)
        told = [f"mem[{first + i}]" for i in range(count)]
        left = [f"mem[{first + count + i}]" for i in range(count)]
        self.a.memory += 2 * count
        acting = " or ".join(f"k % {each} == 0" for each in sorted({every, *before}))

        def copied(to: list[str], source: list[str]) -> list[str]:
            return [f"    {a} = {b}" for a, b in zip(to, source, strict=True)]

        return (
            [f"if k > 0 and ({acting}):", *copied(inputs, told)],
            [f"if {acting}:", *copied(told, inputs),
             f"if k % {every} == 0:", f"    {call}", *copied(left, inputs),
             f"elif {acting}:", *copied(inputs, left)],
        )  # fmt: skip

    def watch(self, stops: tuple[Part, ...]) -> None:
        m = self.device.m
        watch: list[str] = []
        jump: list[str] = []
        for k, stop in enumerate(stops):
            own = self.a.add(stop, f"stop.{k + 1}")
            call = self.a.call(stop, f"stop.{k + 1}", "guard", self.a.common() | own)
            watch.append(f"out[{2 * m + len(self.a.guards)}] = {call}")
            jump += [f"if which == {len(self.a.guards)}:", f"    return {stop.code}"]  # type: ignore[attr-defined]
            self.a.guards.append(f"stop.{k + 1}")
        for k, effect in enumerate(self.effects):
            given = self.a.common() | self.own[k] | {"dmode": "dmode", "rec": "rec"}
            if effect.coordinate >= 0:
                j, n = effect.coordinate, self.device.n
                given |= {"position": f"y[{j}]", "speed": f"y[{n + j}]"}
            if effect.clutch >= 0:
                given |= {"excitation": f"y[{2 * self.device.n + effect.clutch}]"}
                given |= {"command": f"held[{effect.clutch}]"}
                given["excitation_at"] = str(2 * self.device.n + effect.clutch)
                watch += self.rate_lines(k)
            for guard in effect.guards:
                i = effect.clutch
                now = given | {"rate": "rate", "slip": f"w{i}"}
                now |= {"level": f"level{i}", "breakaway": f"breakaway{i}"}
                call = self.a.call(effect, self.names[k], f"{guard}_guard", now)
                watch.append(f"out[{2 * m + len(self.a.guards)}] = {call}")
                call = self.a.call(effect, self.names[k], f"{guard}_jump", given)
                jump += [f"if which == {len(self.a.guards)}:", f"    {call}", "    return 1"]
                self.a.guards.append(f"{self.names[k]}.{guard}")
        self.a.bodies["watch"], self.a.bodies["jump"] = watch, jump
