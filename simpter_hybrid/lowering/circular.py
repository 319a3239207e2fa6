"""Sine and cosine written out, so that a flow's several calls overlap and share their work.

Arguments are reduced by pi/2 in two parts and two polynomials evaluated (Cody & Waite 1980; the
coefficients of FreeBSD's msun, ``k_sin.c`` and ``k_cos.c``): within 1.5 units in the last place
(beside zeros within 1e-28) for arguments up to 1e6; the sine of -0.0 is 0.0.  The C library serves
larger arguments, infinities and NaN.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir

from .kinds import F64, I64

LIMIT = 1e6
#: pi/2 is the sum of both; the first times an integer below 2^20 is exact within ``fma``.
HALF_PI, REST = 1.5707963267948966, 6.123233995736766e-17
#: Added to a small number it leaves the nearest integer in the last bits.
ROUNDER = 1.5 * 2.0**52
SINE = (
    -1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
    2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10,
)  # fmt: skip
COSINE = (
    4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
    -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11,
)  # fmt: skip


def define(module: ir.Module, name: str) -> ir.Function:
    """The function ``sin`` or ``cos`` of a module, to be inlined."""
    kind = ir.FunctionType(F64, [F64])
    f = ir.Function(module, kind, f"circular_{name}")
    f.linkage = "internal"
    f.attributes.add("alwaysinline")
    f.attributes.add("nounwind")
    x = f.args[0]
    b = ir.IRBuilder(f.append_basic_block())
    size = b.call(module.declare_intrinsic("llvm.fabs", [F64], kind), [x])
    far = b.fcmp_unordered(">", size, F64(LIMIT))
    found = near(module, b, x, 1 if name == "cos" else 0)
    here, other, end = b.block, f.append_basic_block(), f.append_basic_block()
    b.cbranch(far, other, end).set_weights([1, 1000])
    b.position_at_end(other)
    called = b.call(module.declare_intrinsic("llvm." + name, [F64], kind), [x])
    b.branch(end)
    b.position_at_end(end)
    phi = b.phi(F64)
    phi.add_incoming(found, here)
    phi.add_incoming(called, other)
    b.ret(phi)
    return f


def near(module: ir.Module, b: ir.IRBuilder, x: Any, quarter: int) -> Any:
    """The sine of ``x`` plus ``quarter`` right angles, below ``LIMIT``."""
    fma = module.declare_intrinsic("llvm.fma", [F64], ir.FunctionType(F64, [F64] * 3))

    def series(z: Any, square: Any, fourth: Any, w: tuple[float, ...]) -> Any:
        # In pairs (Estrin): a flow waits for its sines, so that depth counts.
        low, middle, high = (b.call(fma, [z, F64(w[k + 1]), F64(w[k])]) for k in (0, 2, 4))
        return b.call(fma, [fourth, high, b.call(fma, [square, middle, low])])

    shifted = b.call(fma, [x, F64(1.0 / HALF_PI), F64(ROUNDER)])
    less = b.fsub(F64(ROUNDER), shifted)
    r = b.call(fma, [less, F64(HALF_PI), x])
    r = b.call(fma, [less, F64(REST), r])
    z = b.fmul(r, r)
    square = b.fmul(z, z)
    fourth = b.fmul(square, square)
    sine = b.call(fma, [b.fmul(z, r), series(z, square, fourth, SINE), r])
    half = b.fmul(z, F64(0.5))
    most = b.fsub(F64(1.0), half)
    lost = b.fsub(b.fsub(F64(1.0), most), half)
    cosine = b.fadd(most, b.call(fma, [square, series(z, square, fourth, COSINE), lost]))
    turn = b.bitcast(shifted, I64)
    if quarter:
        turn = b.add(turn, I64(quarter))
    odd = b.icmp_signed("!=", b.and_(turn, I64(1)), I64(0))
    sign = b.shl(b.and_(turn, I64(2)), I64(62))
    bits = b.bitcast(b.select(odd, cosine, sine), I64)
    return b.bitcast(b.xor(bits, sign), F64)
