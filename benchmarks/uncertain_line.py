"""The line of chapter 5 with everything varied that the thesis does not print, for sweeps."""

from __future__ import annotations

from simpter_hybrid.rigs.inputs import entry

#: Path in ``line-y24-p016`` -> entry of ``devices/pter_parameters.toml`` that has a range.
INFERRED = {
    "device.l_a": "linkage.l_a",
    "device.l_d": "linkage.l_d",
    "device.alpha": "linkage.alpha",
    "device.beta": "linkage.beta",
    "device.gamma": "linkage.gamma",
    "controller.stages.0.stiffness": "controller.impedance_stiffness",
    "controller.stages.0.damping": "controller.impedance_damping",
    "controller.stages.1.torque": "controller.table_torque_at_full_scale",
    "stops.0.x": "line.stop_x",
    **{f"loads.0.lines.{k}.1": "line.sinusoid_frequency" for k in range(4)},
}
#: Ranges of more than a factor of 3: there ratios matter.
RATIOS = {"controller.impedance_damping", "line.sinusoid_frequency"}

SCENARIO = "line-y24-p016"
GAIN = "controller.stages.2.gain"


def uncertain() -> list[str]:
    """``--vary`` texts of the 17 inputs that are inferred: plausible ranges, phases over a turn."""
    texts = []
    for path, name in INFERRED.items():
        low, high = entry(name)["range"]
        texts.append(f"{path}={low}..{high}" + (":log" if name in RATIOS else ""))
    return texts + [f"loads.0.lines.{k}.2=0..6.28318530718 rad" for k in range(4)]
