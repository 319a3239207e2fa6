"""Cases of the own generator, each named by what it hides: the name gives the seed.

``slew-limit@0.6.coloured.2`` hides slew-limit at strength 0.6 under coloured noise and is the
second draw; ``stribeck+imbalance@1.white.1`` two effects, ``drawn.drift@0.6+pull-in@1.white.1`` two
that were drawn, each with a strength, ``null.white.7`` none, and
``poor.wear-in@1.white.1`` one-way runs; ``declared.torque-scale@1.white.1`` no effect, but a
declared value far off.  ``advised.wear-in@1.white.1`` is the same rig with the
runs made that the diagnosis of the poor one asks for; ``without.stribeck@1.white.1`` the recording
of ``stribeck@1.white.1``, diagnosed with all that is right taken out of the library.
"""

from __future__ import annotations

import hashlib
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from own_testbed_effects import KINDS

NOISES = ("white", "coloured")
PAIRS = (
    ("stribeck", "imbalance"), ("asymmetry", "slew-limit"), ("position-friction", "viscous-drag"),
    ("thermal-fade", "dwell-breakaway"), ("play-hysteresis", "neighbour-command"),
    ("wear-in", "release-asymmetry"), ("stribeck", "play-hysteresis"),
    ("sensor-gain", "asymmetry"), ("imbalance", "position-friction-2"), ("drift", "pull-in"),
)  # fmt: skip
#: What one-way runs confuse or cannot show, and what they can.
POOR = (
    "stribeck", "wear-in", "thermal-fade", "play-hysteresis", "asymmetry", "imbalance",
    "position-friction", "slew-limit", "added-inertia", "viscous-drag",
)  # fmt: skip
#: The commonest effects are made weaker as well, down to where they are not found.
COMMONEST = (
    "stribeck", "asymmetry", "position-friction", "thermal-fade", "play-hysteresis", "slew-limit",
    "viscous-drag", "added-inertia",
)  # fmt: skip
STRENGTHS, WEAKER = (1.0, 0.6, 0.35), (0.2, 0.1)
#: Draws of a null under one noise, and of everything else.
NULLS, DRAWS = 100, 6
#: Pairs that are drawn, a draw, and what their strengths are drawn from.
DRAWN, DRAWN_STRENGTHS = 10, (1.0, 0.6)
#: Not drawn: the pairs had been drawn before these were in the library.
UNDRAWN = (
    "presliding-springs", "backlash", "rate-breakaway", "press-power", "motor-gain", "motor-offset",
)  # fmt: skip
#: Nulls of one noise before the next draw of everything else.
NULLS_A_DRAW = 10


@dataclass(frozen=True)
class OwnCase:
    """One recording to be diagnosed."""

    name: str
    group: str
    effects: tuple[tuple[str, float], ...]
    noise: str
    batteries: str = "rich"

    @property
    def seed(self) -> int:
        """From the name, so that a case is the same in whatever subset it is run."""
        name = self.name.removeprefix("without.").replace("advised.", "poor.")
        return int.from_bytes(hashlib.sha256(name.encode()).digest()[:4], "big")

    @property
    def removed(self) -> tuple[str, ...]:
        """Effects of the library that the diagnosis must do without."""
        every = [KINDS[name].names for name, _ in self.effects]
        return tuple(n for names in every for n in names) if self.group == "without" else ()


def cases() -> list[OwnCase]:
    """All cases, so ordered that any beginning of the list is a fair part of it."""
    found: list[OwnCase] = []
    rounds = max(DRAWS, -(-NULLS // NULLS_A_DRAW))
    for draw in range(1, rounds + 1):
        found += _nulls(draw)
        if draw <= DRAWS:
            found += _of_effects(draw)
    return found


def _nulls(draw: int) -> Iterator[OwnCase]:
    for k in range((draw - 1) * NULLS_A_DRAW, min(draw * NULLS_A_DRAW, NULLS)):
        for noise in NOISES:
            yield OwnCase(f"null.{noise}.{k + 1}", "null", (), noise)


def _of_effects(draw: int) -> list[OwnCase]:
    """One draw of everything that hides something; noises take turns over effects and draws."""
    known = [name for name, kind in KINDS.items() if kind.names and not kind.declared]
    declared = [name for name, kind in KINDS.items() if kind.declared]
    unknown = [name for name, kind in KINDS.items() if not kind.names]
    found = []
    for turn, strength in enumerate(STRENGTHS):
        for group, names in (("single", known), ("outside", unknown)):
            for k, name in enumerate(names):
                if group == "single" or strength > 0.5:
                    found.append(
                        _case(group, (name,), strength, NOISES[(k + draw + turn) % 2], draw)
                    )
        if strength == 1.0:
            for k, pair in enumerate(PAIRS):
                found.append(_case("pair", pair, strength, NOISES[(k + draw) % 2], draw))
            found += _drawn(draw, [name for name in known if name not in UNDRAWN])
            for group in ("poor", "advised"):
                for name in POOR:
                    found.append(_case(group, (name,), strength, NOISES[(draw + 1) % 2], draw))
            for k, name in enumerate(known):
                found.append(_case("without", (name,), strength, NOISES[(k + draw) % 2], draw))
    for k, name in enumerate(declared):
        found.append(_case("declared", (name,), 1.0, NOISES[(k + draw) % 2], draw))
    for turn, strength in enumerate(WEAKER):
        for k, name in enumerate(COMMONEST):
            found.append(_case("single", (name,), strength, NOISES[(k + draw + turn) % 2], draw))
    return found


def _drawn(draw: int, known: list[str]) -> list[OwnCase]:
    """Pairs of any two effects of the library, of any two strengths."""
    rng = np.random.default_rng([2026, draw])
    found: dict[str, OwnCase] = {}
    while len(found) < DRAWN:
        names = rng.choice(known, 2, replace=False).tolist()
        effects = tuple(zip(names, rng.choice(DRAWN_STRENGTHS, 2).tolist(), strict=True))
        hides = "+".join(f"{name}@{strength:g}" for name, strength in effects)
        noise = NOISES[(len(found) + draw) % 2]
        name = f"drawn.{hides}.{noise}.{draw}"
        found[name] = OwnCase(name, "drawn", effects, noise)
    return list(found.values())


def _case(group: str, names: tuple[str, ...], strength: float, noise: str, draw: int) -> OwnCase:
    head = f"{group}." if group in ("poor", "advised", "without", "declared") else ""
    name = f"{head}{'+'.join(names)}@{strength:g}.{noise}.{draw}"
    effects = tuple((n, strength) for n in names)
    return OwnCase(name, group, effects, noise, "poor" if group in ("poor", "advised") else "rich")
