"""Write docs/devices-and-effects.md: what the code says of its devices and effects.

    python docs/parts_page.py [--check]

Ports, parameters and experiments come from the classes, the closed-form tests from the tests that
name a class. ``--check`` only says whether the page is fresh.
"""

from __future__ import annotations

import ast
import dataclasses
import re
import sys
from functools import cache
from pathlib import Path

from simpter_hybrid.effect import Effect
from simpter_hybrid.known_units import BY_COORDINATE
from simpter_hybrid.reading.kinds import shipped
from simpter_hybrid.units import si_unit

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "devices-and-effects.md"
#: Beginnings of the files whose tests are about single effects.
TESTS = (
    "test_effects_", "test_backlash_", "test_friction_by_", "test_rigs_of_", "test_an_empirical_",
)  # fmt: skip
#: Port -> what it changes, in a word or two.
PORTS = {
    "slip_torque": "slip torque", "break_torque": "breakaway", "bristle_torque": "stiction",
    "effective_excitation": "excitation to torque", "seen_command": "command",
    "excitation_rate": "lag", "force": "force", "inertia": "inertia",
}  # fmt: skip
#: Method of ``Effect`` -> what it replaces.
CHANGES = {"changed_delay": "delay", "changed_threshold": "threshold"}
#: Device -> how it was brought in.
DEVICES = {
    "pter": "Derived from its geometry by `python -m derivations` (Lagrange, held against Kane): "
    "mass matrix, velocity terms, clutch map, tip and its Jacobian, and the reduced equations of "
    "all 16 stuck subsets are generated modules (`devices/pter_equations.py`, `pter_reduced.py`); "
    "the class only names parameters and surfaces.",
    "testbed": "Four functions by hand: one rotor, one clutch to ground. With the torque sensor's "
    "compliance it is `sensor-testbed`, a second coordinate with a spring.",
    "sensor-testbed": "Four functions and a conservative force by hand: the clutch's coil stands "
    "on the sensor's spring (thesis (40)-(42)). `with_mount(Testbed(...), 0, ...)` makes the same "
    "device from the one without, and a test holds them together.",
    "one-axis": "Declared in TOML, no code: inertia, gravity, gear and rotor are numbers of the "
    "device; motor law, servo and always engaged friction are other parts of the file. The "
    "pendulum with joint friction and the measured servos are files of this kind; the coordinate "
    "may be prescribed (`prescribed-motion`).",
    "linear-axis": "As `one-axis`, sliding: a positioning table, a seal tester.",
    "two-link": "Declared in TOML, no code: two joints in a row with gravity and motors; the "
    "textbook's equations written as four functions and a conservative force.",
    "shaft-pair": "Four functions by hand, a dozen lines: two inertias, a clutch between them and "
    "a brake on the second.",
    "belt-and-mass": "Four functions and the spring's force by hand; the belt is a second, heavy "
    "coordinate, so that the textbook's stick-slip needs nothing special.",
    "force-feedback-mouse": "Four functions by hand after the thesis's 6.2.1, a line or two each: "
    "the inertia is constant, the clutch map is PTER's with clutches 3 and 4 exchanged, in metres.",
    "planar-arm": "A Lagrangian given to `derive_device` (symbols, kinetic energy, slip angles): "
    "three coordinates, five clutches, two of them on the tip's position, so that the clutch map "
    "depends on the pose. The text it wrote is the module; locks that contradict each other are "
    "found and explained.",
}

DEVICES_HEAD = """# Devices and effects

Made by `python docs/parts_page.py` from the code.

## Devices

Each passes `check_device`; energy budget, exact stiction and Moreau's time stepping with its step
halved four times: `pytest tests/test_every_device*`, and PTER's own tests.
"""
EFFECTS_HEAD = """Any of these with a constant clutch map may be extended, in a file by
`[[device.with]]` with a `kind`, a `clutch` (from 1) and a `name`, in Python by the functions of
`devices/extended.py`: a `shaft` (the clutch behind a compliant shaft, `inertia`, `stiffness`,
`damping`; a gear with play where `backlash` acts on the new coordinate), a `mount` (the clutch on
a compliant mount, the same keys), `drag` (one more surface beside the clutch; any device may have
it).

## Effects

`[[effects]]` in a scenario: `kind`, then `clutch` (from 1) or `coordinate` (its name), and the
parameters. Bounds in brackets; behind `~` the typical size of a change worth looking for. For all
effects alike, tests hold that the energy budget closes, that a stuck clutch does not slip, that
size zero changes nothing, and that both engines do the same.

| effect | port | parameters | closed form or limit | experiment that reveals it |
|---|---|---|---|---|"""
SENSORS = """
What instruments add is no effect of the model. `[readings]` with its `rate` and
`[[readings.sensors]]` (`signal`, e.g. `"torque of clutch 1"`, `gain`, `offset`, `noise`, `step`,
`delay`, `average`, `filter`, `clock_shift`, `clock_rate`, `seed`, `differentiated` with
`speed_filter`; and `force_turned`, by which the force on a tip is shown turned, `force_crosstalk`,
of which part along y its x shows, and along x its y) puts
sensors on a run, whose readings are the run's `readings.csv`; the controller stage `measurement` is
what controllers see (gain, offset, noise, resolution, lateness, differentiated potentiometers, a
filter, tachometers); a diagnosis weighs a torque sensor's gain, offset, delay and lag against the
effects: `pytest tests/test_sensors* tests/test_a_file_puts* tests/test_controllers_may_see*`.
"""


def main() -> int:
    """Write or check the page."""
    return written(PAGE, page(), Path(__file__).name)


def written(file: Path, text: str, program: str) -> int:
    """Write a page, or with ``--check`` say whether it is fresh; returns the exit code."""
    if "--check" in sys.argv[1:]:
        fresh = file.is_file() and file.read_text(encoding="utf-8") == text
        print("fresh" if fresh else f"stale: run python {program}")
        return 0 if fresh else 1
    file.write_text(text, encoding="utf-8")
    return 0


def page() -> str:
    """The page's text."""
    lines = [DEVICES_HEAD]
    for kind, cls in shipped("device").items():
        numbers = (len(cls.coordinates), "coordinate"), (len(cls.surfaces), "surface")
        size = ", ".join(f"{count} {word}{'s' * (count > 1)}" for count, word in numbers)
        lines += [f"**{kind}** ({size}). {first_sentence(cls)} {DEVICES[kind]}", ""]
    lines += [EFFECTS_HEAD]
    lines += [row(kind, cls) for kind, cls in shipped("effect").items()]
    return "\n".join([*lines, SENSORS])


def first_sentence(cls: type) -> str:
    """Of the class's docstring."""
    text = " ".join((cls.__doc__ or "").split("\n\n")[0].split()).split("``")[0]
    return text.rstrip(".: ") + "."


def row(kind: str, cls: type[Effect]) -> str:
    """One line of the table."""
    found = tests_of(kind, cls.__name__)
    if not found:
        raise SystemExit(f"{cls.__name__}: no test names it")
    cells = [
        f"**{kind}**: {first_sentence_of_module(cls)}", ports(cls), parameters(cls),
        "; ".join(found), cls.reveals,
    ]  # fmt: skip
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |"


def first_sentence_of_module(cls: type) -> str:
    """What the effect is, from its module's docstring; its own where it shares the module."""
    module = sys.modules[cls.__module__]
    own = [c for c in shipped("effect").values() if c.__module__ == cls.__module__]
    text = (module.__doc__ if len(own) == 1 else cls.__doc__) or ""
    return " ".join(text.split("\n\n")[0].split()).rstrip(".")


def ports(cls: type[Effect]) -> str:
    """What it changes, of a clutch or a coordinate."""
    functions = {name for name, f in vars(cls).items() if isinstance(f, staticmethod)}
    found = [words for port, words in PORTS.items() if port in functions]
    found += [words for method, words in CHANGES.items() if method in vars(cls)]
    place = "coordinate" if functions & {"force", "inertia"} else "clutch"
    more = f"; {len(cls.states)} state{'s' * (len(cls.states) > 1)}" if cls.states else ""
    more += f"; {len(cls.guards)} guard{'s' * (len(cls.guards) > 1)}" if cls.guards else ""
    return f"{place}: {', '.join(found)}{more}"


def parameters(cls: type[Effect]) -> str:
    """``rise [0, 5] ~0.2; fade rad/s [> 0]``."""
    found = []
    for f in dataclasses.fields(cls):
        if "columns" in f.metadata:
            columns = ", ".join(name for name, _ in f.metadata["columns"])
            found.append(f"{f.name} (rows of {columns})")
        elif "dimension" in f.metadata:
            found.append(parameter_text(f))
        elif "index" in f.metadata:
            found.append(f"{f.name} (number)")
    return "; ".join(found)


def parameter_text(f: dataclasses.Field) -> str:
    """Name, unit, bounds and typical size of one parameter."""
    m = f.metadata
    unit = si_unit(BY_COORDINATE.get(m["dimension"], {}).get("angle", m["dimension"]))
    low, high = m.get("low"), m.get("high")
    low = f"> {m['above']:g}" if m.get("above") is not None else low
    words = [f.name, unit or ""]
    if low is not None or high is not None:
        ends = [low if isinstance(low, str) else f"{low:g}" if low is not None else ""]
        ends += [f"{high:g}"] if high is not None else []
        words.append(f"[{' ... '.join(ends)}]" if high is not None or "> " in ends[0]
                     else f"[>= {ends[0]}]")  # fmt: skip
    if m.get("typical") is not None:
        words.append(f"~{m['typical']:g}")
    return " ".join(w for w in words if w)


@cache
def test_functions() -> tuple[tuple[str, frozenset[str]], ...]:
    """Every test's name as a sentence, and the names that its text mentions."""
    found = []
    for file in sorted((ROOT / "tests").glob("test_*.py")):
        if not file.name.startswith(TESTS):
            continue
        body = ast.parse(file.read_text(encoding="utf-8")).body
        texts = {
            node.targets[0].id: strings(node) | names_in(node)
            for node in body
            if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
        }
        functions = [node for node in body if isinstance(node, ast.FunctionDef)]
        for node in functions:
            texts[node.name] = names_in(node) | strings(node)
        for node in functions:
            if node.name.startswith("test_"):
                names = texts[node.name].union(*(texts.get(n, ()) for n in texts[node.name]))
                found.append((node.name.removeprefix("test_").replace("_", " "), frozenset(names)))
    return tuple(found)


def names_in(node: ast.AST) -> set[str]:
    """Names that a node's text mentions."""
    return {n.id for n in ast.walk(node) if isinstance(n, ast.Name)}


def strings(node: ast.AST) -> set[str]:
    """What stands in quotes in a node's texts, as ``kind = "backlash"`` in TOML."""
    values = [n.value for n in ast.walk(node) if isinstance(n, ast.Constant)]
    return {w for v in values if isinstance(v, str) for w in re.findall(r'"([\w-]+)"', v)}


def tests_of(kind: str, name: str) -> list[str]:
    """Tests that name an effect by its class or its kind in a file, three at most."""
    return [words for words, names in test_functions() if {kind, name} & names][:3]


if __name__ == "__main__":
    sys.exit(main())
