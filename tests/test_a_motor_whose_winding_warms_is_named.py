"""Copper conducts worse as it warms: a motor driven by voltage pushes less after a while."""

import numpy as np
from axis_recordings import written
from motor_by_voltage import FRICTION, MAP, MODEL, J, K, R

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.diagnosis import diagnose

#: Growth of the resistance for each joule, and the load's friction over that of the model.
RISE, LOADED = 0.08, 2.0
DRIVEN = MAP.replace("channels.duty", "channels.drive").replace(
    'column = "duty"\nunit = "1"', 'column = "volts"\nunit = "V"'
)


def takes(folder):
    """Three takes of voltages in steps by Euler's rule, in 100 steps a row."""
    generator, step, rows = np.random.default_rng(5), 0.01, ["take,s,rate,volts,supply"]
    for take in range(3):
        volts = np.repeat(generator.permutation([9.0, 9.5, 10.0, 10.5, 11.0, 11.5, 12.0]), 40)
        speed, heat = 60.0, 0.0
        for k, told in enumerate(volts):
            seen = speed + generator.normal(0.0, 0.2)
            rows.append(f"{take},{k * step:.2f},{seen:.3f},{told},12")
            for _ in range(100):
                warm = R * (1.0 + RISE * heat)
                current = (told - K * speed) / warm
                speed += step / 100 * (K * current - LOADED * FRICTION) / J
                heat += step / 100 * current**2 * warm
    return written(folder, rows, DRIVEN)


def test_it_is(tmp_path):
    friction = f'coulomb = "{FRICTION} N*m"', f'coulomb = "{LOADED * FRICTION} N*m"'
    done = diagnose(takes(tmp_path), parse(MODEL.replace(*friction))).search
    (found,) = done.corrected.effects
    assert found.name == "winding-heat"
    per_joule = done.corrected.values["winding-heat.rise"] / found.effects()[0].energy
    # Of the heat a part leaves by the fitted cooling, which three seconds hardly tell.
    assert 0.8 * RISE < per_joule < 1.3 * RISE
    assert done.corrected.select_error < 1.1 * done.floor
