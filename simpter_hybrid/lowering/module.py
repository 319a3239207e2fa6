"""Modules of machine code from source text."""

from __future__ import annotations

import ast
import ctypes
import ctypes.util
import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

import llvmlite
import llvmlite.binding as llvm
from llvmlite import ir

from . import circular
from .assigned import check_assigned
from .expressions import KNOWN, LIBRARY
from .functions import Body
from .kinds import F64, I64, Unsupported, result_type, types_of


class Made(NamedTuple):
    """A translated function and the kind of its result."""

    ll: ir.Function
    result: Any


@dataclass
class Space:
    """Functions and numbers that a source text defines."""

    functions: dict[str, ast.FunctionDef] = field(default_factory=dict)
    constants: dict[str, Any] = field(default_factory=dict)

    def add(self, text: str) -> None:
        """Take in a source text: functions, and numbers given names."""
        for node in ast.parse(text).body:
            if isinstance(node, ast.FunctionDef):
                self.functions[node.name] = node
            elif isinstance(node, ast.Assign) and len(node.targets) == 1:
                try:
                    values = ast.literal_eval(node.value)
                except ValueError:
                    continue
                target = node.targets[0]
                if isinstance(target, ast.Tuple):
                    names = [t.id for t in target.elts if isinstance(t, ast.Name)]
                    self.constants.update(zip(names, values, strict=True))
                elif isinstance(target, ast.Name):
                    self.constants[target.id] = values


class Translation:
    """A module in the making.

    Parameters
    ----------
    work : mapping
        Kind and first entry of every work field.
    records : mapping
        Kinds of the fields of every record.
    model_kinds : mapping
        Kinds of arguments and result of the model's functions.
    model : Space, optional
        Where the model's functions are to be found; without it they are called by address.
    fixed : mapping
        Integers that are known now, by record and field.
    own_sines : bool
        Sines and cosines are written out; else they are the C library's, as Python's are.
    """

    def __init__(
        self,
        work: Mapping[str, tuple[str, int]],
        records: Mapping[str, Mapping[str, str]],
        model_kinds: Mapping[str, tuple[tuple[str, ...], str]],
        model: Space | None = None,
        fixed: Mapping[tuple[str, str], int] | None = None,
        own_sines: bool = True,
    ) -> None:
        self.work, self.records, self.model_kinds = work, records, model_kinds
        self.model, self.fixed, self.own_sines = model, fixed or {}, own_sines
        self.ir = ir.Module("simpter", context=ir.Context())
        self.made: dict[Any, Made] = {}
        root = self.ir.add_metadata(["simpter"])
        self.tags = {}
        for tag in ("A", "I", "slot"):
            kind = self.ir.add_metadata([tag, root, I64(0)])
            self.tags[tag] = self.ir.add_metadata([kind, kind, I64(0)])

    def known(self, name: str) -> ir.Function:
        """A mathematical function that LLVM knows."""
        count = 2 if name in ("pow", "copysign") else 1
        kind = ir.FunctionType(F64, [F64] * count)
        return self.ir.declare_intrinsic("llvm." + name, [F64], kind)

    def circular(self, name: str) -> ir.Function:
        """Sine or cosine, written out."""
        found = self.ir.globals.get("circular_" + name)
        return found or circular.define(self.ir, name)

    def library(self, name: str, count: int) -> ir.Function:
        """A function of the C library."""
        found = self.ir.globals.get(name)
        return found or ir.Function(self.ir, ir.FunctionType(F64, [F64] * count), name)

    def function(self, space: Space, name: str, args: tuple[Any, ...]) -> Made:
        """The function ``name`` for arguments of the given kinds, translated once."""
        key = (id(space), name, args)
        if key not in self.made:
            made = self.translate(space, name, args, self.ir.get_unique_name("f_" + name))
            apart = self.model_kinds if space is self.model else space.constants.get("APART", ())
            if name in apart:
                set_apart(made.ll)
            self.made[key] = made
        return self.made[key]

    def translate(self, space: Space, name: str, args: tuple[Any, ...], symbol: str) -> Made:
        """Translate a function for arguments of given kinds.

        It is translated again as long as kinds of its variables change, for at most eight times.

        Raises
        ------
        Unsupported
            If a part of it cannot be translated, or the kinds do not settle.
        """
        types = [t for kind in args for t in types_of(kind)]
        kinds: dict[str, Any] = {}
        source = space.functions[name]
        for attempt in range(8):
            result = kinds.get("return")
            made_type = result_type("none" if result is None else result)
            f = ir.Function(self.ir, ir.FunctionType(made_type, types), f"{symbol}.{attempt}")
            f.linkage = "internal"
            f.attributes.add("nounwind")
            body = Body(self, space, source, kinds)
            try:
                body.translate(f, args)
                if not body.dirty:  # by now all its syntax is known to be the dialect's
                    check_assigned(source)
            except Unsupported as error:
                raise Unsupported(f"in {name}: {error}") from error
            if not body.dirty:
                return Made(f, body.result)
            del self.ir.globals[f.name]
            kinds = {**body.kinds, "return": body.result}
        raise Unsupported(f"in {name}: the kinds of its values do not settle")

    def export(self, space: Space, name: str, args: tuple[Any, ...], apart: bool = False) -> None:
        """Make a function callable from outside; ``apart``: its arrays never overlap."""
        made = self.translate(space, name, args, "export_" + name)
        inner = made.ll
        f = ir.Function(self.ir, inner.function_type, name)
        builder = ir.IRBuilder(f.append_basic_block())
        inner.attributes.add("alwaysinline")
        if apart:
            set_apart(inner)
            set_apart(f)
        found = builder.call(inner, f.args)
        if made.result == "none":
            builder.ret_void()
        else:
            builder.ret(found)


def set_apart(f: ir.Function) -> None:
    """Promise that the arrays a function is given never overlap."""
    for a in f.args:
        if isinstance(a.type, ir.PointerType):
            a.add_attribute("noalias")


def machine() -> Any:
    """The machine that code is made for; a new one every time, since an engine keeps its own."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    features = llvm.get_host_cpu_features().flatten()
    return target.create_target_machine(opt=2, cpu=llvm.get_host_cpu_name(), features=features)


def fingerprint(*texts: str) -> str:
    """What the machine code of sources depends on, as a short word."""
    what = (*texts, llvmlite.__version__, llvm.get_host_cpu_name(), llvm.get_default_triple())
    return hashlib.sha256("\0".join(what).encode()).hexdigest()[:24]


def object_code(translation: Translation, level: int = 2) -> bytes:
    """Optimised machine code of a finished translation."""
    tm = machine()
    translation.ir.triple = llvm.get_default_triple()
    translation.ir.data_layout = str(tm.target_data)
    module = llvm.parse_assembly(str(translation.ir))
    options = llvm.create_pipeline_tuning_options(speed_level=level)
    options.loop_vectorization = True
    options.slp_vectorization = True
    passes = llvm.create_pass_builder(tm, options)
    passes.getModulePassManager().run(module, passes)
    return tm.emit_object(module)


def callables(code: bytes, names: Sequence[str]) -> tuple[Any, tuple[int, ...]]:
    """The engine that holds the code (keep it) and the addresses of functions."""
    own = ctypes.CDLL(ctypes.util.find_library("m") or None)
    for name in (*KNOWN, *LIBRARY, "floor", "ceil", "fma", "rint"):
        if hasattr(own, name):
            llvm.add_symbol(name, ctypes.cast(getattr(own, name), ctypes.c_void_p).value)
    module = llvm.parse_assembly("")
    engine = llvm.create_mcjit_compiler(module, machine())
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    return engine, tuple(engine.get_function_address(name) for name in names)
