"""Assembly: parts in, six flat functions and a parameter vector out.

The text written here is the only bridge between parts (objects that name and validate) and numerics
(flat functions).  The reference engine executes it as Python; the compiled engine compiles the same
text.
"""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

from ..device import Device
from ..part import Part, arguments_of, source_of
from .names import HEADER, unknown_names
from .slices import stored_into

#: Arguments of the assembled functions.
SIGNATURES = {
    "map": "y, p, C",
    "terms": "t, y, p, rec, held, mode, dmode, s, M, C, c, f, Q, fr",
    "rates": "t, y, p, rec, held, mode, gate, dmode, tau, C, s, dy",
    "watch": "t, y, p, rec, held, mode, dmode, s, out",
    "control": "k, t, y, tau, p, rec, s, held, mem",
    "jump": "which, t, y, p, rec, held, dmode",
}

#: Signals of forces through a clutch, for torques alone; the second ones only a device of one
#: coordinate and one clutch has.
TRANSMITTED = ("applied", "conservative")
SINGLE = ("net", "mass")


class WiringError(TypeError):
    """A part's function asks for a name that nothing provides."""


@dataclass
class Assembly:
    """Collects parameters and function texts of the parts of one model."""

    device: Device
    names: list[str] = field(default_factory=list)
    values: list[float] = field(default_factory=list)
    sources: dict[str, str] = field(default_factory=dict)
    bodies: dict[str, list[str]] = field(default_factory=lambda: {k: [] for k in SIGNATURES})
    held: list[str] = field(default_factory=list)
    states: list[str] = field(default_factory=list)
    memory: int = 0
    modes: int = 0
    guards: list[str] = field(default_factory=list)
    #: Of every stage, what its arguments are by name, and where its memory begins.
    stages: list[tuple[dict[str, str], int]] = field(default_factory=list)

    def add(self, part: Part, prefix: str) -> dict[str, str]:
        """Register a part's parameters and functions; returns expressions for its parameters.

        Raises
        ------
        WiringError
            If a function stores into a slice.
        """
        self.check_slices(part)
        provides: dict[str, str] = {}
        for name, value in part.parameters().items():
            provides[name] = f"p[{len(self.values)}]"
            self.names.append(f"{prefix}.{name}")
            self.values.append(value)
        provides["table_at"] = str(len(self.values))
        for k, value in enumerate(part.table()):
            self.names.append(f"{prefix}.table.{k}")
            self.values.append(value)
        tag = re.sub(r"\W", "_", prefix)
        for function in part.uses:
            self.sources[function.__name__] = source_of(function, function.__name__)
        for name, function in part.functions().items():
            self.sources[f"{tag}_{name}"] = source_of(function, f"{tag}_{name}")
        return provides

    def check_slices(self, part: Part) -> None:
        """Refuse a part whose functions would do something else as Python than compiled."""
        known = tuple(self.device.functions().items())
        found = stored_into(type(part), known)  # type: ignore[arg-type]
        if found is not None:
            function, written, array = found
            raise WiringError(
                f"{type(part).__name__}.{function} stores into {written}, a slice of {array}: as "
                "Python that changes a copy, compiled the array itself; store into the array by "
                "its index, as in mem[mem_at + 1] = ..., or into scratch, a slice of s"
            )

    def call(self, part: Part, prefix: str, name: str, provides: Mapping[str, str]) -> str:
        """Text of a call of a part's function, wired by argument name.

        Raises
        ------
        WiringError
            If the function asks for an argument that nothing provides, or uses a name that the
            assembled module does not have.
        """
        for each in unknown_names(part, (name,), self.device):
            raise WiringError(
                f"{type(part).__name__}.{name} cannot be put into the model: {each.function} "
                f"{each.what} ({each.value}); right would be {each.right}"
            )
        function = part.functions()[name]
        tag = re.sub(r"\W", "_", prefix)
        words = []
        for argument in arguments_of(function):
            if argument not in provides:
                raise WiringError(
                    f"{type(part).__name__}.{name} asks for {argument!r}, which "
                    f"{self.lacking(argument, provides)}"
                )
            words.append(provides[argument])
        return f"{tag}_{name}({', '.join(words)})"

    def lacking(self, argument: str, provides: Mapping[str, str]) -> str:
        """Why there is no such argument, and what there is."""
        n, m = self.device.n, self.device.m
        if argument in TRANSMITTED or (argument in SINGLE and n == m == 1):
            return (
                "only torques may ask for (slip_torque, break_torque, bristle_torque of a clutch): "
                "forces are not known elsewhere"
            )
        if argument in SINGLE:
            return (
                "only a device of one coordinate and one clutch has: "
                f"{type(self.device).__name__} has {n} and {m}"
            )
        prefix, _, held = argument.partition("_")
        if prefix in ("held", "at") and held:
            drives = held.startswith("drive")
            such = ', such as kind = "position-servo"; in a diagnosis the record drives' * drives
            return (
                f"no stage of the controller writes: a held input {held!r} ([controller] with a "
                f"rate and a stage that writes it, before any that reads it{such})"
            )
        return f"nothing provides here; available: {', '.join(sorted(provides))}"

    def common(self) -> dict[str, str]:
        """Names every part may ask for."""
        n = self.device.n
        found = {
            "n": str(n),
            "m": str(self.device.m),
            "time": "t",
            "t": "t",
            "q": "y",
            "y": "y",
            "qd": f"y[{n}:{2 * n}]",
            "p": "p",
            "rec": "rec",
            "held": "held",
            "s": "s",
        }
        for name in self.device.functions():
            found[name] = f"device_{name}"
        for k, name in enumerate(self.held):
            found[f"held_{name}"] = f"held[{self.device.m + k}]"
            found[f"at_{name}"] = str(self.device.m + k)
        if "desired_1" in self.held:
            found["desired_count"] = str(self.desired_count())
        return found

    def desired_count(self) -> int:
        """Number of clutches, from the first on, for each of which a desired torque is held."""
        at, count = self.held.index("desired_1"), 0
        while self.held[at + count : at + count + 1] == [f"desired_{count + 1}"]:
            count += 1
        return min(count, self.device.m)

    def text(self) -> str:
        """The assembled module."""
        parts = [HEADER]
        parts += [self.sources[name] for name in sorted(self.sources)]
        for name, arguments in SIGNATURES.items():
            body = self.bodies[name] or ["pass"]
            end = "    return 0\n" if name == "jump" else ""
            parts.append(f"def {name}({arguments}):\n" + "\n".join("    " + b for b in body))
            parts[-1] += "\n" + end
        return "\n".join(parts)


@functools.lru_cache(maxsize=16)
def execute(text: str) -> Mapping[str, Callable]:
    """Execute assembled text as Python; returns its functions, which keep nothing between calls.

    Those of `SIGNATURES`, and ``tip_force_now``.
    """
    space: dict[str, object] = {"math": math}
    exec(compile(text, "<assembled model>", "exec"), space)
    return {name: space[name] for name in (*SIGNATURES, "tip_force_now")}  # type: ignore[misc]
