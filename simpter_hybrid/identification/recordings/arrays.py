"""Recordings that are named arrays: NPZ, MAT (up to version 7) and TDMS (LabVIEW).

A column may stand upright, (N, 1), or lie, (1, N); fields of a struct are ``struct.field``.
"""

from __future__ import annotations

import zipfile
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

from ...problems import InvalidInput, Problem

#: Endings of the files that are read here.
ENDINGS = (".npz", ".mat", ".tdms")
#: One array without a name, which is no column of a map.
NAMELESS = ".npy"
#: What the readers raise at a file that was cut off or is packed in a way that they do not know.
BROKEN = (IndexError, KeyError, TypeError, RuntimeError, NotImplementedError)


def holds_arrays(source: str) -> bool:
    """Whether a file is one of named arrays, by its ending."""
    return source.lower().endswith((*ENDINGS, NAMELESS))


def read_arrays(source: str) -> Mapping[str, np.ndarray]:
    """All arrays of a file by name, one-dimensional where they are columns.

    Raises
    ------
    InvalidInput
        For a MAT file of version 7.3, an array without a name (NPY), and where the package that
        reads TDMS is missing.
    OSError, ValueError, zipfile.BadZipFile
        If the file cannot be read.
    """
    kind = source.lower()
    if kind.endswith(NAMELESS):
        right = "an NPZ file, numpy.savez(file, name=column, ...): one array for each column"
        problem = Problem(source, "", "one array without a name", "an NPY file", right)
        raise InvalidInput([problem])
    if kind.endswith(".npz"):
        if not zipfile.is_zipfile(source):  # numpy takes it for a pickle and advises to load it
            raise ValueError("a file that is no archive of arrays")
        try:
            with np.load(source, allow_pickle=False) as archive:
                return {name: _column(archive[name]) for name in archive.files}
        except BROKEN as error:
            raise ValueError(str(error)) from None
    return _from_mat(source) if kind.endswith(".mat") else _from_tdms(source)


def _from_mat(source: str) -> dict[str, np.ndarray]:
    from scipy.io import loadmat
    from scipy.io.matlab import MatReadError

    try:
        found = loadmat(source, squeeze_me=True)
    except MatReadError as error:
        raise ValueError(str(error)) from None
    except NotImplementedError:
        right = "a file saved by MATLAB with -v7"
        problem = Problem(source, "", "this version cannot be read", "version 7.3 (HDF5)", right)
        raise InvalidInput([problem]) from None
    except BROKEN as error:
        raise ValueError(str(error)) from None
    return dict(_fields({k: v for k, v in found.items() if not k.startswith("__")}))


def _fields(found: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, np.ndarray]]:
    """Arrays by name, those of a struct and of what is in it as ``struct.field``."""
    for name, value in found.items():
        array = np.asarray(value)
        if array.dtype.names is None:
            yield prefix + name, _column(array)
        elif array.size == 1:  # of an array of structs no field is one column
            inner = {field: array[field].item() for field in array.dtype.names}
            yield from _fields(inner, f"{prefix}{name}.")


def _column(array: np.ndarray) -> np.ndarray:
    """An array less the dimensions in which it has one row or column."""
    return np.atleast_1d(np.squeeze(array))


def _from_tdms(source: str) -> dict[str, np.ndarray]:
    """Channels as ``group/channel``, and by their own name where only one group has it."""
    try:
        from nptdms import TdmsFile
    except ImportError:
        right = "pip install 'simpter_hybrid[tdms]'"
        problem = Problem(source, "", "the package that reads TDMS is missing", "nptdms", right)
        raise InvalidInput([problem]) from None
    channels = [
        (g.name, c.name, c[:]) for g in TdmsFile.read(source).groups() for c in g.channels()
    ]
    owners = Counter(name for _, name, _ in channels)
    found = {f"{group}/{name}": np.atleast_1d(values) for group, name, values in channels}
    own = {name: np.atleast_1d(v) for _, name, v in channels if owners[name] == 1}
    return found | own
