"""The closed list of units that files may use, and the kinds of quantity that they measure."""

import re
from typing import NamedTuple

PI = "3.14159265358979323846264338327950288"
#: The inch in m and the pound-force in N, both exact.
INCH, LBF = 0.0254, 4.4482216152605

#: Unit as written in a file -> its definition (pint syntax).
UNITS = {
    "m": "[length]", "s": "[time]", "kg": "[mass]", "A": "[current]", "K": "[temperature]",
    "rad": "[]",
    "um": "1e-6 m", "mm": "1e-3 m", "cm": "1e-2 m", "km": "1e3 m", "in": f"{INCH} m", "ft": "12 in",
    "us": "1e-6 s", "ms": "1e-3 s", "min": "60 s", "h": "3600 s",
    "g": "1e-3 kg", "lbm": "0.45359237 kg",
    "N": "kg*m/s**2", "mN": "1e-3 N", "kN": "1e3 N", "lbf": f"{LBF} N",
    "kgf": "9.80665 N", "ozf": "0.0625 lbf", "Nm": "N*m", "mNm": "1e-3 N*m", "slug": "lbf*s**2/ft",
    "mrad": "1e-3 rad", "deg": f"{PI} / 180 rad", "rev": f"2 * {PI} rad", "turn": "rev",
    "rpm": "rev/min",
    "Hz": "1/s", "kHz": "1e3 Hz",
    "Pa": "N/m**2", "kPa": "1e3 Pa", "MPa": "1e6 Pa", "bar": "1e5 Pa", "psi": "lbf/in**2",
    "J": "N*m", "W": "J/s", "V": "W/A", "mV": "1e-3 V", "mA": "1e-3 A",
    "ohm": "V/A", "H": "ohm*s", "mH": "1e-3 H",
    "percent": "0.01",
    "degC": "K; offset: 273.15", "degF": "5 / 9 K; offset: 233.15 + 200 / 9",
}  # fmt: skip

_ANGLES = frozenset({"rad", "mrad", "deg", "rev", "turn", "rpm"})
_CYCLES, _SHARES = frozenset({"Hz", "kHz"}), frozenset({"percent"})


class Dimension(NamedTuple):
    """A kind of quantity: its SI unit, an example of how to write it, units refused in it."""

    si: str
    example: str
    refused: frozenset[str] = frozenset()


DIMENSIONS = {
    "dimensionless": Dimension("", "0.5", _ANGLES),
    "length": Dimension("m", "24 in"),
    "time": Dimension("s", "20 ms"),
    "mass": Dimension("kg", "2 lbm"),
    "angle": Dimension("rad", "45 deg", _SHARES),
    "force": Dimension("N", "7 lbf"),
    "torque": Dimension("N*m", "65 lbf*in"),
    "speed": Dimension("m/s", "2 in/s"),
    "acceleration": Dimension("m/s^2", "50 in/s^2"),
    "angular_speed": Dimension("rad/s", "1.5 rad/s", _CYCLES | _SHARES),
    "angular_acceleration": Dimension("rad/s^2", "10 rad/s^2", _CYCLES | _SHARES),
    "frequency": Dimension("Hz", "150 Hz", _ANGLES | _SHARES),
    "inertia": Dimension("kg*m^2", "300 lbf*in*s^2"),
    "stiffness": Dimension("N/m", "32 lbf/in"),
    "damping": Dimension("N*s/m", "0.7 lbf*s/in"),
    "rotational_stiffness": Dimension("N*m/rad", "400 lbf*in/rad"),
    "rotational_damping": Dimension("N*m*s/rad", "0.5 lbf*in*s/rad"),
    "voltage": Dimension("V", "10 V"),
    "current": Dimension("A", "0.5 A"),
    "resistance": Dimension("ohm", "25 ohm"),
    "inductance": Dimension("H", "0.4 H"),
    "pressure": Dimension("Pa", "90 psi"),
    "power": Dimension("W", "15 W"),
    "temperature": Dimension("K", "20 degC"),
}

#: Dimensions that depend on what a device's coordinate measures.
BY_COORDINATE = {
    "coordinate": {"angle": "angle", "length": "length"},
    "coordinate speed": {"angle": "angular_speed", "length": "speed"},
    "per coordinate speed": {"angle": "1/angular_speed", "length": "1/speed"},
    "coordinate force": {"angle": "torque", "length": "force"},
    "coordinate force rate": {"angle": "torque/time", "length": "force/time"},
    "coordinate damping": {"angle": "rotational_damping", "length": "damping"},
    "coordinate damping a kelvin": {
        "angle": "rotational_damping/temperature",
        "length": "damping/temperature",
    },
    "coordinate drag": {"angle": "torque/angular_speed^2", "length": "force/speed^2"},
    "coordinate stiffness": {"angle": "rotational_stiffness", "length": "stiffness"},
    "coordinate stiffening": {"angle": "torque/angle^3", "length": "force/length^3"},
    "coordinate inertia": {"angle": "inertia", "length": "mass"},
    "coordinate gain": {"angle": "voltage/angle", "length": "voltage/length"},
    "coordinate speed gain": {"angle": "voltage/angular_speed", "length": "voltage/speed"},
    "coordinate integral gain": {
        "angle": "voltage/(angle*time)",
        "length": "voltage/(length*time)",
    },
    "force a volt": {"angle": "torque/voltage", "length": "force/voltage"},
    "force a squared volt": {"angle": "torque/voltage^2", "length": "force/voltage^2"},
    "volt a force": {"angle": "voltage/torque", "length": "voltage/force"},
    "volt a force and second": {
        "angle": "voltage/(torque*time)",
        "length": "voltage/(force*time)",
    },
    "steering gain": {"angle": "torque*length/angle", "length": "force/angle"},
    "force an ampere": {"angle": "torque/current", "length": "force/current"},
}


def unknown_in(dimension: str) -> list[str]:
    """Words that name neither a dimension nor a unit: of ``"torque/furlong"`` the second.

    Parameters
    ----------
    dimension : str
        As in `units.parse_quantity`, or one of `BY_COORDINATE`, in which nothing is unknown.
    """
    if dimension in BY_COORDINATE:
        return []
    words = re.findall(r"[A-Za-z_]\w*", dimension)
    return [word for word in words if word not in DIMENSIONS and word not in UNITS]
