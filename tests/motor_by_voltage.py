"""A motor of known constants that turns against dry friction: its model and the map of its logs."""

#: Inertia [kg m^2], constant [N m/A], resistance [ohm], supply [V], friction [N m].
J, K, R, SUPPLY, FRICTION = 5e-5, 0.06, 15.0, 12.0, 0.01
MODEL = f"""
[run]
t_end = "2 s"
[start]
coordinates = ["0 rad"]
[device]
kind = "one-axis"
inertia = "{J} kg*m^2"
[clutch]
time_constant = "0 s"
delay = "0 s"
threshold = "-1 V"
torque = {{ kind = "coulomb-viscous", coulomb = "{FRICTION} N*m" }}
[[loads]]
kind = "voltage-drive"
constant = "{K} N*m/A"
resistance = "{R} ohm"
[controller]
rate = "1 kHz"
[[controller.stages]]
kind = "axis-speed-servo"
points = [["0 s", "0 rad/s"], ["1 s", "50 rad/s"]]
proportional = "0.1 V/(rad/s)"
limit = "12 V"
[[tolerances]]
name = "Coulomb friction"
parameters = ["clutch.1.torque.coulomb"]
relative = 0.3
[[tolerances]]
name = "motor constant"
parameters = ["load.1.constant"]
relative = 0.1
"""
MAP = """
[time]
column = "s"
unit = "s"
[runs]
boundaries = ["take"]
[channels.speed]
column = "rate"
unit = "rad/s"
sign = 1
role = "measured"
may_rest = true
[channels.duty]
column = "duty"
unit = "1"
sign = 1
role = "input"
held = "after"
[channels.supply]
column = "supply"
unit = "V"
sign = 1
role = "constant"
"""
