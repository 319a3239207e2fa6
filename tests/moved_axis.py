"""A linear axis that a tester moves: its model and its map."""

MODEL = """
[run]
t_end = "5 s"
[device]
kind = "linear-axis"
mass = "MASS kg"
[start]
coordinates = ["0 m"]
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = { kind = "coulomb-viscous", FRICTION }
[[tolerances]]
name = "Coulomb"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.5
"""
MAP = """
[time]
column = "t"
unit = "s"
[runs]
boundaries = ["run"]
group = ["run"]
[channels.position]
column = "x"
unit = "m"
sign = 1
role = "input"
[channels.force]
column = "F"
unit = "N"
sign = 1
role = "measured"
"""
#: A drive for a record to take the place of, with its rate.
DRIVEN = """
[[loads]]
kind = "force-drive"
constant = "1 N/V"
[controller]
rate = "100 Hz"
[[controller.stages]]
kind = "position-servo"
points = [["0 s", "0 m"], ["1 s", "0 m"]]
proportional = "1 V/m"
limit = "1 V"
"""


def model(mass: float, friction: str) -> str:
    """TOML of such an axis with keys of its friction, without motor and controller."""
    return MODEL.replace("MASS", str(mass)).replace("FRICTION", friction)
