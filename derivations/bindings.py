"""Where the generated code finds the value of each symbol: the layout of q, qd, g, p, brk."""

from __future__ import annotations

import sympy as sp

from derivations.symbols import ALPHA, BETA, BRK, G1, G2, GAMMA, L_A, L_D, TH1, TH2, W1, W2

COORDINATES = {TH1: "q[0]", TH2: "q[1]"}
SPEEDS = {W1: "qd[0]", W2: "qd[1]"}
FORCES = {G1: "g[0]", G2: "g[1]"}
BREAKAWAY = {symbol: f"brk[{index}]" for index, symbol in enumerate(BRK)}
#: order of the flat parameter vector p, SI units
PARAMETERS = {ALPHA: "p[0]", BETA: "p[1]", GAMMA: "p[2]", L_A: "p[3]", L_D: "p[4]"}

LAYOUT: dict[str, dict[sp.Symbol, str]] = {
    "q": COORDINATES,
    "qd": SPEEDS,
    "g": FORCES,
    "brk": BREAKAWAY,
    "p": PARAMETERS,
}


def bindings(arguments: tuple[str, ...]) -> dict[sp.Symbol, str]:
    """Bindings for a function that takes some of q, qd, g, brk, p."""
    found: dict[sp.Symbol, str] = {}
    for argument in arguments:
        found.update(LAYOUT.get(argument, {}))
    return found
