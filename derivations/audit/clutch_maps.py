"""Equations (39) and (43), Tables 3 and 4: torque maps against each other and their own numbers.

The raw data are lost, but the tables suffice: residuals of a least-squares quadratic are orthogonal
to every quadratic, so with f_k the fits of Table 3 and m any multiple of a quadratic
sum (data - m)^2 = sum (data - f_k)^2 + sum (f_k - m)^2, and likewise for scale factors.
"""

from __future__ import annotations

import math

from derivations.audit.compare import rounds_to
from derivations.audit.verdict import Entry

#: speed [rad/s]: quadratic, linear, constant [lb-in, V], sum of squares, error per point [lb-in]
TABLE_3 = {
    0.194: (6.060, -0.193, 1.496, "1018", "4.98"),
    0.394: (6.439, 0.137, 0.371, "1219", "5.45"),
    0.792: (6.834, 2.167, -1.102, "889.9", "4.66"),
    1.193: (7.158, 3.143, -2.405, "984.8", "4.90"),
    1.591: (6.954, 5.445, -3.899, "1005", "4.95"),
    1.990: (7.462, 4.312, -2.711, "871.8", "4.61"),
}
#: speed [rad/s]: sum of squares, error per point [lb-in]
TABLE_4 = {
    0.194: ("4907", "10.93"), 0.394: ("1230", "5.48"), 0.792: ("4924", "10.96"),
    1.193: ("6047", "12.14"), 1.591: ("3153", "8.77"), 1.990: ("2792", "8.25"),
}  # fmt: skip
VOLTS = [0.25 * k for k in range(41)]
SLOPE, OFFSET, BASE_SPEED = 0.154, 0.9409, 0.394
FULL_SCALE = 750.0  # lb-in, the top of Figure 25
#: half a unit of the last printed digit of the coefficients, of SLOPE and of OFFSET
HALF_COEFFICIENT, HALF_SLOPE, HALF_OFFSET = 5e-4, 5e-4, 5e-5


def _norm(values: list[float]) -> float:
    return math.sqrt(sum(x * x for x in values))


def fit(speed: float) -> list[float]:
    """Table 3's quadratic on the 41 excitations [lb-in]."""
    a, b, c = TABLE_3[speed][:3]
    return [a * v * v + b * v + c for v in VOLTS]


def scale_factor(speed: float) -> float:
    """Best multiple of the base quadratic for one speed's data, exact by orthogonality."""
    base = fit(BASE_SPEED)
    return sum(f * b for f, b in zip(fit(speed), base, strict=True)) / sum(b * b for b in base)


def dynamic(volts: float, speed: float) -> float:
    """(39) [lb-in]."""
    return (SLOPE * speed + OFFSET) * (6.439 * volts**2 + 0.137 * volts + 0.371)


def breakaway(volts: float) -> float:
    """(43) [lb-in]."""
    return 6.648 * volts**2 + 6.176 * volts + 5.253


def _coefficient_rounding() -> float:
    """Norm [lb-in] of what rounding of Table 3 may change in a fit on the 41 excitations."""
    return HALF_COEFFICIENT * _norm([v * v + v + 1.0 for v in VOLTS])


def scale_line() -> tuple[float, float, float, float]:
    """Least-squares line through the six scale factors and the rounding bounds of its two terms."""
    speeds = list(TABLE_3)
    mean = sum(speeds) / len(speeds)
    spread = sum((w - mean) ** 2 for w in speeds)
    weights = [(w - mean) / spread for w in speeds]
    factors = [scale_factor(w) for w in speeds]
    slope = sum(k * f for k, f in zip(weights, factors, strict=True))
    offset = sum(factors) / len(factors) - slope * mean
    # a change d of the base and of the fit changes a factor by at most 2 |d| / |base|, roughly
    bound = 2.5 * _coefficient_rounding() / _norm(fit(BASE_SPEED))
    slope_bound = bound * sum(abs(k) for k in weights)
    return slope, offset, slope_bound, bound + slope_bound * mean


def _scale_line_is_printed() -> bool:
    slope, offset, slope_bound, offset_bound = scale_line()
    return (
        abs(slope - SLOPE) <= HALF_SLOPE + slope_bound
        and abs(offset - OFFSET) <= HALF_OFFSET + offset_bound
    )


def table_4_sum(speed: float, slope: float = SLOPE) -> float:
    """Table 4's sum of squares [(lb-in)^2] recomputed from Table 3 and (39)."""
    scale = slope * speed + OFFSET
    misfit = [f - scale * b for f, b in zip(fit(speed), fit(BASE_SPEED), strict=True)]
    return float(TABLE_3[speed][3]) + _norm(misfit) ** 2


def table_4_slack(speed: float) -> float:
    """What rounding of the printed numbers may change in the misfit's norm [lb-in]."""
    scale_rounding = HALF_SLOPE * speed + HALF_OFFSET
    return 2.5 * _coefficient_rounding() + scale_rounding * _norm(fit(BASE_SPEED))


def _table_4_row(speed: float) -> bool:
    recomputed = math.sqrt(table_4_sum(speed) - float(TABLE_3[speed][3]))
    printed = math.sqrt(float(TABLE_4[speed][0]) - float(TABLE_3[speed][3]))
    return abs(recomputed - printed) <= table_4_slack(speed)


def _error_per_point(total: str, printed: str) -> bool:
    """Root of the mean square over 41 points, allowing for the rounding of the printed sum."""
    half = 0.5 if "." not in total else 0.05
    low, high = (math.sqrt((float(total) + d) / len(VOLTS)) for d in (-half, half))
    return any(rounds_to(x, printed) for x in (low, high)) or low <= float(printed) <= high


def _passive_and_rising() -> list[float]:
    """Speeds whose fit starts above zero and rises from zero excitation on."""
    return [w for w, (a, b, c, *_) in TABLE_3.items() if c > 0 and b >= 0 and a > 0]


def _breakaway_above_dynamic() -> bool:
    return all(breakaway(v) > dynamic(v, 0.194) for v in [0.01 * k for k in range(1001)])


def _worst_row(slope: float = SLOPE) -> float:
    return max(abs(table_4_sum(w, slope) / float(TABLE_4[w][0]) - 1.0) for w in TABLE_4)


def entries() -> list[Entry]:
    """Entries of equations (39), (43) and of Tables 3 and 4."""
    return [
        Entry(
            "39", "dynamic torque of a clutch",
            "line through the six scale factors recomputed from Table 3, to rounding",
            _scale_line_is_printed,
            remark="recomputed: {:.4f} w + {:.4f}; Table 4 wants a slope of 0.1545: the printed "
            "0.154 is at the very edge of its last digit".format(*scale_line()[:2]),
        ),
        Entry(
            "43", "breakaway torque of a clutch",
            "above (39) at 0.194 rad/s for 0 to 10 V, as Figure 33 says; data not available",
            _breakaway_above_dynamic,
            remark="no data below 2.25 V; 5.253 lb-in remain at zero excitation",
        ),
        Entry("Table 3", "error per point of the six fits", "root of sum / 41",
              lambda: all(_error_per_point(*row[3:]) for row in TABLE_3.values())),
        Entry("Table 3, choice", "only the 0.394 rad/s fit is positive and rising from 0 V",
              "the coefficients", lambda: _passive_and_rising() == [BASE_SPEED]),
        Entry(
            "Table 4, errors", "error per point of the scaled fit", "root of sum / 41",
            lambda: all(_error_per_point(*row) for row in TABLE_4.values()),
            corrected="10.94 instead of 10.93 at 0.194 rad/s",
            correction=lambda: all(
                _error_per_point(total, "10.94" if w == 0.194 else printed)
                for w, (total, printed) in TABLE_4.items()
            ),
        ),
        Entry(
            "Table 4", "sums of squares of the scaled fit",
            "recomputed from Table 3 and (39) by orthogonality, within the rounding of both",
            lambda: all(_table_4_row(w) for w in TABLE_4),
            remark=f"with the printed slope up to {100 * _worst_row():.1f} % off, with 0.1545 "
            f"within {100 * _worst_row(0.1545):.1f} %",
        ),
        Entry(
            "4.6.2.1", "average errors below 1 and 2 percent of full scale",
            "Tables 3 and 4 against 750 lb-in",
            lambda: max(float(r[4]) for r in TABLE_3.values()) < 0.01 * FULL_SCALE
            and max(float(r[1]) for r in TABLE_4.values()) < 0.02 * FULL_SCALE,
        ),
    ]  # fmt: skip
