"""The subsets of stuck clutches: rank, null space, closure, facets of what they can hold.

Works for any constant clutch map of numbers; PTER's 2**4 = 16 subsets collapse to 6 motions.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import sympy as sp


@dataclass(frozen=True)
class StuckSet:
    """A subset S of the clutches that is stuck.

    Attributes
    ----------
    clutches
        0-based numbers, ascending.
    rows
        C_S, rows of the clutch map (len(S), n).
    rank
        Rank of C_S.
    closure
        All clutches whose slip velocity is then zero: those with rows in the span of C_S.
    null_space
        N (n, n - rank): directions that are still free, qd = N v.
    """

    clutches: tuple[int, ...]
    rows: sp.Matrix
    rank: int
    closure: tuple[int, ...]
    null_space: sp.Matrix

    @property
    def mask(self) -> int:
        """Bit i is set if clutch i + 1 is stuck."""
        return mask_of(self.clutches)

    @property
    def independent(self) -> bool:
        """Whether equilibrium alone determines every holding torque."""
        return self.rank == len(self.clutches)

    @property
    def motion(self) -> str:
        """Name of the motion that is left: what is stuck, up to redundancy."""
        if self.null_space.cols == 0:
            return "locked"
        return "_".join(["clutch", *(str(i + 1) for i in self.closure)]) if self.rank else "free"


def mask_of(clutches: tuple[int, ...]) -> int:
    """Bit mask of 0-based clutch numbers."""
    return sum(1 << clutch for clutch in clutches)


def stuck_set(clutch_map: sp.Matrix, clutches: tuple[int, ...]) -> StuckSet:
    """Describe one subset of the rows of ``clutch_map``."""
    n = clutch_map.cols
    rows = sp.Matrix([list(clutch_map[i, :]) for i in clutches]) if clutches else sp.zeros(0, n)
    rank = rows.rank() if clutches else 0
    closure = tuple(
        i for i in range(clutch_map.rows) if sp.Matrix.vstack(rows, clutch_map[i, :]).rank() == rank
    )
    basis = rows.nullspace() if clutches else list(sp.eye(n).columnspace())
    null_space = sp.Matrix.hstack(*basis) if basis else sp.zeros(n, 0)
    return StuckSet(clutches, rows, rank, closure, null_space)


def all_stuck_sets(clutch_map: sp.Matrix) -> tuple[StuckSet, ...]:
    """All 2**m subsets, ordered by mask."""
    m = clutch_map.rows
    subsets = [s for size in range(m + 1) for s in combinations(range(m), size)]
    return tuple(stuck_set(clutch_map, s) for s in sorted(subsets, key=mask_of))


def facet_normals(stuck: StuckSet) -> tuple[sp.Matrix, ...]:
    """Normals y of the zonotope {C_S' tau : |tau_i| <= tau_break_i}, one of each opposite pair.

    y is left at rest by some rank - 1 independent rows of C_S and lies in the row space of C_S
    (modulo its null space). Scaled to max |C_i y| = 1 over S, so that the margin
    sum |C_i y| tau_break_i - |y . h| of an independent set is tau_break_i - |tau_i| [N m].
    """
    if stuck.rank == 0:
        return ()
    row_space = stuck.rows.T.columnspace()
    span = sp.Matrix.hstack(*row_space)
    normals: list[sp.Matrix] = []
    for chosen in combinations(range(len(stuck.clutches)), stuck.rank - 1):
        at_rest = sp.Matrix([list(stuck.rows[i, :]) for i in chosen])
        if chosen:
            if at_rest.rank() < stuck.rank - 1:
                continue
            (coefficients,) = (at_rest * span).nullspace()
        else:
            coefficients = sp.ones(1, 1)
        normal = span * coefficients
        normal /= max(abs(x) for x in stuck.rows * normal)
        if normal not in normals and -normal not in normals:
            normals.append(normal)
    return tuple(normals)
