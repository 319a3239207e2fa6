"""The counts of chapter 3: modes, subcases, special cases, and what the special cases decide."""

from __future__ import annotations

import random
from itertools import combinations
from math import comb

import sympy as sp

from derivations.audit.case_algebra import IN_A, IN_B
from derivations.audit.special_cases import LIMITS, at_breakaway
from derivations.audit.verdict import CONTRADICTED, Entry
from derivations.geometry import CLUTCH_MAP
from derivations.stuck_sets import StuckSet, all_stuck_sets, facet_normals, stuck_set

SETS = all_stuck_sets(CLUTCH_MAP)
S, N, F = "stick", "NA", "slip/NA"
#: Table 1 and Table 7 as printed
TABLE_1 = {
    "1": (F, F, F, F), "2.1": (S, F, F, F), "2.2": (F, S, F, F), "3.1": (F, F, S, F),
    "3.2": (F, F, F, S), "4.1": (S, N, S, N), "4.2": (S, N, N, S), "4.3": (N, S, S, N),
    "4.4": (N, S, N, S), "5": (S, S, N, N), "6": (N, N, S, S), "7": (S, S, S, S),
}  # fmt: skip
TABLE_7 = {
    "1": (F, F, F, F), "2.1": (S, F, F, F), "2.2": (F, S, F, F), "3.1": (F, F, S, F),
    "3.2": (F, F, F, S), "4.1": (S, N, S, N), "4.2": (S, N, N, S), "4.3": (N, S, S, N),
    "4.4": (N, S, N, S), "5": (S, S, N, N), "6": (N, N, S, S), "7": (S, S, S, S),
}  # fmt: skip
#: Table 2: applied clutches of the subcases
TABLE_2 = {"7.1": (1, 2, 3), "7.2": (1, 2, 4), "7.3": (1, 3, 4), "7.4": (2, 3, 4),
           "7.5": (1, 2, 3, 4)}  # fmt: skip


def _sticking(row: tuple[str, ...]) -> tuple[int, ...]:
    return tuple(i for i, state in enumerate(row) if state == S)


def _table_1_is_derived() -> bool:
    """Rows are all sets of at most two clutches and all four; the others slip only if they can."""
    wanted = {s.clutches for s in SETS if len(s.clutches) in (0, 1, 2, 4)}
    rows_fit = all(
        all(
            (state == N) == (i in set(stuck.closure) - set(stuck.clutches))
            for i, state in enumerate(row)
        )
        for row in TABLE_1.values()
        for stuck in [stuck_set(CLUTCH_MAP, _sticking(row))]
    )
    return {_sticking(r) for r in TABLE_1.values()} == wanted and rows_fit


def _modes() -> int:
    """Rows of Table 1: the independent sets one by one, the redundant ones together as Case 7."""
    return sum(1 for s in SETS if s.independent) + 1


def _unachievable(pairs_too: bool) -> list[StuckSet]:
    """Sets that do not exist when all four clutches are applied: a slipping one would stick."""
    sizes = (2, 3) if pairs_too else (3,)
    return [s for s in SETS if s.closure != s.clutches and len(s.clutches) in sizes]


def _special_cases(clutches: int) -> int:
    """How many choices of clutches at breakaway leave as many unknowns as equations."""
    return comb(clutches, clutches - CLUTCH_MAP.rank())


def _decisions(directions: tuple[int, ...]) -> tuple[int, int]:
    """Random loads on Case 7.1: held but called slipping; slipping but called held."""
    triple = stuck_set(CLUTCH_MAP, (0, 1, 2))
    normals = [sp.lambdify((), list(y))() for y in facet_normals(triple)]
    reach = [[abs(float(c)) for c in triple.rows * y] for y in facet_normals(triple)]
    symbols = [IN_A, IN_B, *LIMITS.values()]
    cases = [
        sp.lambdify(symbols, [at_breakaway(x, d)[i] for i in (1, 2, 3)])
        for x in LIMITS
        for d in directions
    ]
    rng = random.Random(4)
    missed = invented = 0
    for _ in range(4000):
        load = [rng.uniform(-2.0, 2.0) for _ in range(2)]
        limits = [rng.uniform(0.2, 1.0) for _ in range(3)]
        holds = all(
            sum(r * b for r, b in zip(row, limits, strict=True))
            >= abs(y[0] * load[0] + y[1] * load[1])
            for y, row in zip(normals, reach, strict=True)
        )
        said = any(
            all(abs(t) <= b for t, b in zip(case(*load, *limits), limits, strict=True))
            for case in cases
        )
        missed += holds and not said
        invented += said and not holds
    return missed, invented


def _released(clutches: tuple[int, ...]) -> set[int]:
    """How many clutches reach breakaway together on the facets of what a set can hold."""
    stuck = stuck_set(CLUTCH_MAP, clutches)
    return {sum(1 for x in stuck.rows * y if x != 0) for y in facet_normals(stuck)}


def entries() -> list[Entry]:
    """Entries of the counts."""
    derived = "counted over the 16 subsets of stuck clutches"
    triples = list(combinations(range(4), 3))
    return [
        Entry("3.2.3.4, modes", "twelve possible modes, Case 7 for three and for four", derived,
              lambda: _modes() == 12 == len(TABLE_1)),
        Entry(
            "3.2.3.4, 24 - 4", "24 possible, minus four", "arithmetic",
            lambda: 24 - 4 == 12, "exponent", lambda: 2**4 - 4 == 12 and len(SETS) == 2**4,
        ),
        Entry(
            "3.2.3.4, four", "four unachievable states, such as 1 slipping and 2, 3, 4 sticking",
            derived, lambda: len(_unachievable(pairs_too=True)) == 4,
            condition="triples with the fourth clutch applied; the six pairs are no less "
            "unachievable unless the others are not applied (NA in Table 1), and with the fourth "
            "not applied the triples exist (Table 2)",
            conditional=lambda: len(_unachievable(pairs_too=False)) == 4
            and len(_unachievable(pairs_too=True)) == 10,
        ),
        Entry("Table 1", "modes of the four clutches", "closure of every row's sticking clutches",
              _table_1_is_derived),
        Entry("Table 7", "the same table again", "compared with Table 1",
              lambda: TABLE_1 == TABLE_7),
        Entry("Table 2", "five subcases of Case 7", derived,
              lambda: {tuple(i + 1 for i in s.clutches) for s in SETS if len(s.clutches) > 2}
              == set(TABLE_2.values()) and len(TABLE_2) == 5),
        Entry("3.2.3.4, 7.1", "three special cases, six torques",
              "equilibrium has two equations", lambda: _special_cases(3) == 3
              and 3 * (3 - 1) == 6 and all(stuck_set(CLUTCH_MAP, t).rank == 2 for t in triples)),
        Entry("3.2.3.4, 7.5", "six special cases", "equilibrium has two equations",
              lambda: _special_cases(4) == 6),
        Entry("3.2.3.4, static", "if one special case is feasible, the system remains static",
              "4000 random loads against the exact stick margin of clutches 1, 2, 3",
              lambda: _decisions((1,))[1] == 0),
        Entry(
            "3.2.3.4, dynamic", "if none is, it starts to move",
            "4000 random loads against the exact stick margin of clutches 1, 2, 3",
            lambda: _decisions((1,))[0] == 0,
            condition="both directions of each breakaway torque are tried, six cases instead of "
            "three",
            conditional=lambda: _decisions((1, -1)) == (0, 0),
            remark=f"with (24)-(29) as printed {_decisions((1,))[0]} of 4000 loads that can be "
            "held are said to slip",
        ),
        Entry(
            "3.2.3.4, two slip", "the two clutches closest to breakaway will slip",
            "clutches at breakaway on the facets of what the set can hold",
            lambda: all(_released(t) == {2} for t in [*triples, (0, 1, 2, 3)]),
            condition="three clutches applied; with four (7.5) three reach breakaway together and "
            "one stays",
            conditional=lambda: all(_released(t) == {2} for t in triples)
            and _released((0, 1, 2, 3)) == {3},
            fault=CONTRADICTED,
        ),
        Entry("4.6.2.1, 246", "41 excitations from 0 to 10 V by 0.25 V, 6 speeds, 246 tests",
              "arithmetic", lambda: int(10 / 0.25) + 1 == 41 and 41 * 6 == 246),
    ]  # fmt: skip
