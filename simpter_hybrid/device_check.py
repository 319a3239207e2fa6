"""Does a device describe a mechanism? Which of its arrays is wrong, and how."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

import numpy as np

from .assembly.names import unknown_names
from .device import Device, wrong_dimensions
from .part import arguments_of

#: What a device has to define, with the arguments and the length of what it writes.
FUNCTIONS = {
    "mass_matrix": (("q", "p", "out"), lambda n, m: n * n),
    "velocity_terms": (("q", "qd", "p", "out"), lambda n, m: n),
    "clutch_map": (("q", "p", "out"), lambda n, m: m * n),
    "clutch_map_rate": (("q", "qd", "p", "out"), lambda n, m: m),
}
OPTIONAL = {
    "conservative_force": (("q", "p", "out"), lambda n, m: n),
    "damping_force": (("q", "qd", "p", "out"), lambda n, m: n),
    "tip": (("q", "p", "out"), lambda n, m: 2),
    "tip_jacobian": (("q", "p", "out"), lambda n, m: 2 * n),
    "tip_jacobian_rate": (("q", "qd", "p", "out"), lambda n, m: 2),
}
#: Relative error of a central difference with steps of 1e-5, with room to spare.
NEAR = 1e-6


class DeviceFinding(NamedTuple):
    """Which array is wrong, what about it, the value met, and what would be right."""

    array: str
    what: str
    value: object
    right: str

    def __str__(self) -> str:
        return f"{self.array}: {self.what}, got {self.value}; expected {self.right}"


def check_device(device: Device, poses: Sequence[Sequence[float]] = ()) -> list[DeviceFinding]:
    """Findings about a device at the poses given (and eight drawn ones), empty if it is sound.

    Checks what coordinates are said to measure, names that functions use without having them,
    shapes (every entry written, none beyond), finite numbers, a symmetric and positive definite
    mass matrix, velocity terms that belong to it (the Christoffel terms, nothing odd in the
    speeds), damping that never gives energy, a clutch map's rate against differences of the map,
    conservative forces against their potential, and the tip's Jacobian and its rate against
    differences of the tip.

    Parameters
    ----------
    device : Device
    poses : sequence of sequence of float, each (n,)
        Coordinates at which it will be used [rad or m].
    """
    found = _signatures(device)
    if found:
        return found
    random = np.random.default_rng(1)
    drawn = list(poses) + list(random.uniform(-1.2, 1.2, (8 if not poses else 2, device.n)))
    for q in drawn:
        view = _View(device, [float(v) for v in q], random.uniform(-1.0, 1.0, device.n).tolist())
        found = _shapes(view) or [
            finding
            for check in (_mass, _velocity, _damping, _map, _potential, _tip)
            for finding in check(view)
        ]
        if found:
            return found
    wired = (*FUNCTIONS, *OPTIONAL, "potential_energy")
    return [DeviceFinding(*each) for each in unknown_names(device, wired)]


def _signatures(device: Device) -> list[DeviceFinding]:
    functions, kinds = device.functions(), device.coordinate_dimensions
    found = []
    if not device.coordinates:
        right = "a tuple of names, one a coordinate"
        found.append(DeviceFinding("coordinates", "there is none", (), right))
    for array, names in (("coordinates", device.coordinates), ("surfaces", device.surfaces)):
        if len(set(names)) < len(names):
            found.append(DeviceFinding(array, "a name twice", names, "a name of its own for each"))
    if wrong := wrong_dimensions(kinds, device.n):
        found.append(DeviceFinding("coordinate_dimensions", wrong[0], kinds, wrong[1]))
    for name, (arguments, _) in (FUNCTIONS | OPTIONAL).items():
        if name not in functions:
            if name in FUNCTIONS:
                right = f"a static function {name}({', '.join(arguments)})"
                found.append(DeviceFinding(name, "missing", "nothing", right))
        elif tuple(arguments_of(functions[name])) != arguments:
            got = ", ".join(arguments_of(functions[name]))
            found.append(
                DeviceFinding(name, "wrong arguments", f"({got})", f"({', '.join(arguments)})")
            )
    return found


class _View:
    """A device at one pose and speed."""

    def __init__(self, device: Device, q: list[float], qd: list[float]) -> None:
        self.device, self.q, self.qd = device, q, qd
        self.functions = device.functions()
        self.p = [*device.parameters().values(), *device.table()]

    def call(self, name: str, q: Any, qd: Any = ()) -> np.ndarray:
        arguments, length = (FUNCTIONS | OPTIONAL)[name]
        out = [math.nan] * length(self.device.n, self.device.m)
        given = {"q": [float(v) for v in q], "qd": [float(v) for v in qd], "p": self.p, "out": out}
        self.functions[name](*(given[a] for a in arguments))
        return np.array(out, dtype=float)

    def along(self, name: str, direction: np.ndarray) -> np.ndarray:
        """Derivative of an array along a change of pose."""
        h = 1e-5
        q = np.array(self.q)
        return (self.call(name, q + h * direction) - self.call(name, q - h * direction)) / (2 * h)


def _shapes(view: _View) -> list[DeviceFinding]:
    found = []
    for name, (_, length) in (FUNCTIONS | OPTIONAL).items():
        if name not in view.functions:
            continue
        n, m = view.device.n, view.device.m
        size = f"{length(n, m)} entries, row by row, for n = {n} and m = {m}"
        try:
            values = view.call(name, view.q, view.qd)
        except IndexError:
            what = "writes or reads beyond its arrays"
            found.append(DeviceFinding(name, what, "IndexError", size))
        except (Exception, SystemExit) as error:  # whatever a user's function does
            what = f"fails ({type(error).__name__}: {error})"
            found.append(DeviceFinding(name, what, f"q = {view.q}", "a function without errors"))
        else:
            wrong = [k for k, v in enumerate(values) if not math.isfinite(v)]
            if wrong:
                what = f"entries {wrong} are not written or not finite"
                found.append(DeviceFinding(name, what, values.tolist(), size))
    return found


def _mass(view: _View) -> list[DeviceFinding]:
    n = view.device.n
    M = view.call("mass_matrix", view.q).reshape(n, n)
    skew = abs(M - M.T)
    if skew.max() > 1e-12 * abs(M).max():
        a, b = np.unravel_index(skew.argmax(), skew.shape)
        value = f"M[{a},{b}] = {M[a, b]:.9g}, M[{b},{a}] = {M[b, a]:.9g}"
        return [DeviceFinding("mass_matrix", "not symmetric", value, "M equal to its transpose")]
    low, vectors = np.linalg.eigh(M)
    if low[0] <= 0.0:
        value = f"kinetic energy {0.5 * low[0]:.6g} J at speeds {vectors[:, 0].round(6).tolist()}"
        what = "not positive definite"
        return [DeviceFinding("mass_matrix", what, value, "energy above 0 for every motion")]
    return []


def _velocity(view: _View) -> list[DeviceFinding]:
    n, qd = view.device.n, np.array(view.qd)
    M = view.call("mass_matrix", view.q)
    slopes = np.array([view.along("mass_matrix", e).reshape(n, n) for e in np.eye(n)])
    expected = np.einsum("kij,j,k->i", slopes, qd, qd)
    expected -= 0.5 * np.einsum("ijk,j,k->i", slopes, qd, qd)
    forward, back = (view.call("velocity_terms", view.q, s * qd) for s in (1.0, -1.0))
    even, odd = 0.5 * (forward + back), 0.5 * (forward - back)
    scale = abs(M).max() * (qd @ qd)
    worst = int(abs(even - expected).argmax())
    if abs(even - expected)[worst] > NEAR * scale:
        power = qd @ (even - expected)
        value = f"{even[worst]:.9g} (it gives {-power:.3g} W that is not there)"
        what = f"entry {worst} does not belong to the mass matrix"
        right = f"{expected[worst]:.9g}, sum of (dM_ij/dq_k - dM_jk/dq_i / 2) qd_j qd_k"
        return [DeviceFinding("velocity_terms", what, value, right)]
    if abs(odd).max() > NEAR * scale:
        what = "a part is odd in the speeds"
        right = "none: what damps is damping_force(q, qd, p, out), which the energy budget counts"
        return [DeviceFinding("velocity_terms", what, odd.tolist(), right)]
    return []


def _damping(view: _View) -> list[DeviceFinding]:
    if "damping_force" not in view.functions:
        return []
    force, qd = view.call("damping_force", view.q, view.qd), np.array(view.qd)
    if qd @ force > NEAR * abs(qd * force).sum():
        power = f"{qd @ force:.6g} W"
        return [DeviceFinding("damping_force", "gives energy", power, "at most 0 W")]
    return []


def _map(view: _View) -> list[DeviceFinding]:
    n, m = view.device.n, view.device.m
    if m == 0:
        return []
    qd = np.array(view.qd)
    C = view.call("clutch_map", view.q).reshape(m, n)
    slope = view.along("clutch_map", qd).reshape(m, n)
    for i in range(m):
        # Zero at a pose alone it is at the dead centre of a crank.
        if not (C[i].any() or slope[i].any()):
            what = f"row {i} is zero: clutch {i + 1} never slips"
            return [DeviceFinding("clutch_map", what, C[i].tolist(), "a row with an entry")]
    rate = view.call("clutch_map_rate", view.q, qd)
    worst = int(abs(slope @ qd - rate).argmax())
    if abs(slope @ qd - rate)[worst] > NEAR * (abs(C).max() * (qd @ qd) + abs(rate).max()):
        value, right = f"{rate[worst]:.9g}", f"{(slope @ qd)[worst]:.9g}, (dC/dt) qd by differences"
        what = f"entry {worst} is not the rate of the map"
        return [DeviceFinding("clutch_map_rate", what, value, right)]
    if view.device.constant_clutch_map and abs(slope).max() > NEAR * abs(C).max():
        what = "depends on the pose although constant_clutch_map says that it does not"
        return [DeviceFinding("clutch_map", what, C.tolist(), "constant_clutch_map = False")]
    return []


def _potential(view: _View) -> list[DeviceFinding]:
    functions = view.functions
    if "potential_energy" not in functions:
        return []
    if "conservative_force" not in functions:
        right = "conservative_force(q, p, out), its negative gradient"
        return [DeviceFinding("potential_energy", "has no force", "nothing", right)]
    energy: Callable = functions["potential_energy"]
    force, q, h = view.call("conservative_force", view.q), np.array(view.q), 1e-5
    slope = np.array(
        [(energy(list(q + h * e), view.p) - energy(list(q - h * e), view.p)) / (2 * h)
         for e in np.eye(len(q))]
    )  # fmt: skip
    worst = int(abs(force + slope).argmax())
    if abs(force + slope)[worst] > NEAR * (abs(slope).max() + abs(force).max() + 1e-9):
        what, right = f"entry {worst} is not -dU/dq", f"{-slope[worst]:.9g}"
        return [DeviceFinding("conservative_force", what, f"{force[worst]:.9g}", right)]
    return []


def _tip(view: _View) -> list[DeviceFinding]:
    if "tip" not in view.functions or "tip_jacobian" not in view.functions:
        return []
    n, qd = view.device.n, np.array(view.qd)
    J = view.call("tip_jacobian", view.q).reshape(2, n)
    slope = np.array([view.along("tip", e) for e in np.eye(n)]).T
    if abs(J - slope).max() > NEAR * abs(slope).max():
        what = "is not the derivative of the tip"
        return [DeviceFinding("tip_jacobian", what, J.tolist(), f"{slope.round(9).tolist()}")]
    if "tip_jacobian_rate" in view.functions:
        rate = view.call("tip_jacobian_rate", view.q, qd)
        expected = view.along("tip_jacobian", qd).reshape(2, n) @ qd
        if abs(rate - expected).max() > NEAR * (abs(J).max() * (qd @ qd)):
            what = "is not (dJ/dt) qd"
            right = f"{expected.round(9).tolist()}"
            return [DeviceFinding("tip_jacobian_rate", what, rate.tolist(), right)]
    return []
