"""Machine code of the kernel and of models, kept on disk under names made from its sources.

The kernel is compiled once for each integration method, for models up to a capacity; a model's
six functions are compiled by themselves and reached by address.  For long sweeps both can be
compiled as one (``together``).
"""

from __future__ import annotations

import hashlib
import os
import tempfile
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from ..kernel.records import COMPILED, work_arrays
from ..kernel.tableau import unrolled
from ..problems import CompiledUnavailable

#: Bytes of the digest behind machine code on disk.
DIGEST = hashlib.sha256().digest_size
#: Kernel modules, in any order.
KERNEL = (
    "records", "linear", "reduction", "margin", "resolution", "motion", "rules", "instant",
    "screen", "stepper", "search", "keeping", "step", "run", "batch",
)  # fmt: skip

#: Kinds of the arguments and results of a model's functions (``model.SIGNATURES``).
MODEL_KINDS: dict[str, tuple[tuple[str, ...], str]] = {
    "map": (("A",) * 3, "none"),
    "terms": (("f", *"AAAAIIAAAAAAA"), "none"),
    "rates": (("f", *"AAAAIIIAAAA"), "none"),
    "watch": (("f", *"AAAAIIAA"), "none"),
    "control": (("i", "f", *"AAAAAAA"), "none"),
    "jump": (("i", "f", *"AAAAI"), "i"),
}


@dataclass(frozen=True)
class Capacity:
    """Largest model that a compiled kernel serves."""

    n: int
    m: int
    ny: int
    ng: int
    nh: int
    nmem: int
    nd: int

    def holds(self, sizes: Mapping[str, int]) -> bool:
        """Whether a model of these sizes fits."""
        return all(sizes[name] <= most for name, most in asdict(self).items())


#: Capacities in order of preference; a kernel is compiled for each that is used.
CAPACITIES = (
    Capacity(n=4, m=6, ny=40, ng=16, nh=24, nmem=128, nd=16),
    Capacity(n=8, m=10, ny=128, ng=64, nh=96, nmem=512, nd=64),
)


def cache_folder() -> Path:
    """Where compiled modules are kept: ``$SIMPTER_CACHE`` or the user's cache folder."""
    base = os.environ.get("SIMPTER_CACHE")
    if base:
        return Path(base)
    root = os.environ.get("XDG_CACHE_HOME") or str(Path.home() / ".cache")
    return Path(root) / "simpter_hybrid"


def capacity(sizes: Mapping[str, int]) -> Capacity:
    """The smallest capacity that serves a model.

    Raises
    ------
    CompiledUnavailable
        If the model is larger than the largest capacity.
    """
    for size in CAPACITIES:
        if size.holds(sizes):
            return size
    what, most = "the model is too large for engine 'compiled'", f"up to {CAPACITIES[-1]}"
    raise CompiledUnavailable(what, str(dict(sizes)), most)


def layout(size: Capacity) -> tuple[dict[str, tuple[str, int]], int, int]:
    """Kind and first entry of every work field; lengths of the float and the integer array."""
    fields = work_arrays(
        size.n, size.m, size.ny, size.ng, size.nh, size.nmem, size.nd,
        lambda k: ("A", k), lambda k: ("I", k),
    )  # fmt: skip
    places, ends = {"real": ("A", 0), "integer": ("I", 0)}, {"A": 0, "I": 0}
    for name, (kind, length) in zip(fields._fields, fields, strict=True):
        places[name] = (kind, ends[kind])
        ends[kind] += length
    return places, ends["A"], ends["I"]


@lru_cache
def kernel_text(method: str) -> str:
    """The kernel's sources, one behind the other, for an integration method."""
    folder = Path(__file__).parents[1] / "kernel"
    return "\n".join([*((folder / f"{name}.py").read_text() for name in KERNEL), unrolled(method)])


@lru_cache
def compiler_text() -> str:
    """The compiler's own sources: machine code kept on disk depends on them."""
    folder = Path(__file__).parents[1] / "lowering"
    return "\n".join(path.read_text() for path in sorted(folder.glob("*.py")))


def lowering() -> Any:
    """The compiler.

    Raises
    ------
    CompiledUnavailable
        If llvmlite is missing.
    """
    try:
        from ..lowering import module
    except ImportError as error:
        right = "llvmlite, by: pip install llvmlite"
        what = "machine code cannot be made here"
        raise CompiledUnavailable(what, "no llvmlite", right) from error
    return module


def kept(name: str, make: Any) -> bytes:
    """The machine code called ``name``, from disk or made now.

    Its digest stands behind it: what a full disk or a power cut has left of a file would be run.
    """
    folder = cache_folder()
    path = folder / f"{name}.o"
    if (known := _whole(path)) is not None:
        return known
    code = make()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile("wb", dir=folder, suffix=".tmp", delete=False) as out:
            try:
                out.write(code + hashlib.sha256(code).digest())
                out.close()
                os.replace(out.name, path)
            except OSError:
                os.unlink(out.name)
    except OSError:
        pass  # A folder that cannot be written to costs time only.
    return code


def kernel_name(size: Capacity, method: str, text: str, fixed: tuple[tuple[str, int], ...]) -> str:
    """Name of a kernel's machine code, made from all its sources."""
    sources = (compiler_text(), kernel_text(method), repr(size), text, repr(fixed))
    own = lowering().fingerprint(*sources)
    return f"kernel_{own}"


def is_kept(name: str) -> bool:
    """Whether machine code of that name is on disk."""
    return _whole(cache_folder() / f"{name}.o") is not None


def _whole(path: Path) -> bytes | None:
    """Machine code of a file, if the digest behind it says that this is all of it."""
    try:
        kept = path.read_bytes()
    except OSError:
        return None
    code, digest = kept[:-DIGEST], kept[-DIGEST:]
    return code if hashlib.sha256(code).digest() == digest else None


@lru_cache(maxsize=64)
def kernel(
    size: Capacity, method: str, text: str = "", fixed: tuple[tuple[str, int], ...] = ()
) -> Any:
    """Engine and address of ``run_batch``; with ``text`` that model's functions are merged in.

    ``fixed`` numbers of a model (its sizes) are constants of the machine code.
    """
    module = lowering()
    name = kernel_name(size, method, text, fixed)

    def make() -> bytes:
        places, _, _ = layout(size)
        space = module.Space()
        space.add(kernel_text(method))
        model = None
        if text:
            model = module.Space()
            model.add(text)
        known = {("md", field): value for field, value in fixed}
        translation = module.Translation(places, COMPILED, MODEL_KINDS, model, known)
        translation.export(space, "run_batch", ("md", "o", "rec", "many", "w"))
        return module.object_code(translation)

    return module.callables(kept(name, make), ["run_batch"])


@lru_cache(maxsize=512)
def model_functions(text: str, own_sines: bool = True) -> Any:
    """Engine and addresses of a model's functions, in the order of ``model.SIGNATURES``.

    Without ``own_sines`` the C library gives sines and cosines, bit for bit as in Python.

    Raises
    ------
    CompiledUnavailable
        If a function is outside the compiled dialect; the message names it.
    """
    module = lowering()
    name = module.fingerprint(compiler_text(), text, "" if own_sines else "the library's sines")

    def make() -> bytes:
        space = module.Space()
        space.add(text)
        translation = module.Translation({}, {}, MODEL_KINDS, own_sines=own_sines)
        try:
            for function, (kinds, _) in MODEL_KINDS.items():
                translation.export(space, function, kinds, apart=True)
        except module.Unsupported as error:
            what = "engine 'compiled' cannot compile this model"
            right = "parts in the dialect of Python that it takes"
            raise CompiledUnavailable(what, str(error), right) from error
        return module.object_code(translation)

    return module.callables(kept(f"model_{name}", make), list(MODEL_KINDS))
