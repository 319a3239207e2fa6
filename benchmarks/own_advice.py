"""The runs that a diagnosis asks for, made by the own generator: do they settle the question?"""

from __future__ import annotations

import numpy as np
from own_testbed_effects import LBF_IN
from own_testbed_plan import Planned

from simpter_hybrid.identification.identifiability_report import Sight
from simpter_hybrid.identification.result import Diagnosis


def advised(found: Diagnosis, seen: Sight) -> list[str]:
    """Experiments that a report names first: for what contests a name, and for what goes unseen."""
    named = {e.listed_as for e in found.search.corrected.effects}
    asked = [runs for (one, _), runs in seen.run_next.items() if one in named]
    asked += [seen.reveals[name] for name in seen.blind if name in seen.reveals]
    return list(dict.fromkeys(runs[0][0] for runs in asked if runs))


def planned(found: Diagnosis, experiments: list[str]) -> list[Planned]:
    """Their commands, as the generator takes them."""
    assert found.experiments is not None
    done = found.search
    plans = found.experiments(done.refitted.values, found.split.select)
    made = []
    for plan in (p for p in plans if p.experiment in experiments):
        by_torque = bool(plan.inputs["servo_mode"][0])
        reference = plan.inputs["reference_torque" if by_torque else "reference_speed"]
        # The recording's columns are in lbf in, plans in N m.
        reference = reference / LBF_IN if by_torque else reference
        inputs = (reference, plan.inputs["command"], plan.inputs["neighbour_command"])
        made.append(Planned(by_torque, *(np.asarray(x, dtype=float) for x in inputs)))
    return made
