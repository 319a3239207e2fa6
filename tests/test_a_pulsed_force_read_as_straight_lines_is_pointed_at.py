"""A drive pulses and its log has the levels; a line through its rows is half a row early."""

import numpy as np
import pytest
from axis_recordings import MAP, NEWTON_METRES, declared_axis

from simpter_hybrid.identification.diagnosis import diagnose
from simpter_hybrid.identification.recordings.recording import load_recording

ROW, STEP = 0.004, 5e-5


def _walked(force):
    """Angles of the declared axis by small steps: friction takes what speed it can."""
    angle, speed, angles = 0.0, 0.0, []
    for acts in force:
        angles.append(angle)
        free = speed + STEP * (acts - 0.5 * np.sin(angle) - 0.02 * speed) / 0.02
        speed = np.sign(free) * max(abs(free) - STEP * 0.2 / 0.02, 0.0)
        angle += STEP * speed
    return np.array(angles)


def _recorded(folder, held):
    rows, every = ["take,ms,angle,torque"], round(ROW / STEP)
    for take in range(3):
        generator = np.random.default_rng(10 + take)
        edges = np.cumsum(generator.integers(15, 40, 60)) * every
        levels = generator.uniform(0.3, 0.9, 61) * (-1.0) ** np.arange(61)
        acts = levels[np.searchsorted(edges, np.arange(round(4.0 / STEP)), side="right")]
        seen = _walked(acts)[::every] + generator.normal(0.0, 2e-4, acts[::every].size)
        rows += [
            f"{take},{1e3 * ROW * k:.1f},{-np.degrees(q):.5f},{u / NEWTON_METRES:.6f}"
            for k, (q, u) in enumerate(zip(seen, acts[::every], strict=True))
        ]
    (folder / "data.csv").write_text("\n".join(rows), encoding="utf-8")
    (folder / "map.toml").write_text(f'{MAP}held = "{held}"\n', encoding="utf-8")
    return load_recording(folder / "data.csv", folder / "map.toml")


@pytest.mark.slow
@pytest.mark.parametrize("held", ["sampled", "after"])
def test_levels_that_hold_are_asked_for_where_a_delay_would_be_named(tmp_path, held):
    found = diagnose(_recorded(tmp_path, held), declared_axis())
    right = held == "after"
    assert [e.name for e in found.search.corrected.effects] == ([] if right else ["force-delay"])
    assert [doubt.change.held for doubt in found.doubts] == ([] if right else ["after"])
