"""Recordings that are named arrays: NPZ, MAT (up to version 7) and TDMS (LabVIEW)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping

import numpy as np

from ...problems import InvalidInput, Problem

#: Endings of the files that are read here.
ENDINGS = (".npz", ".mat", ".tdms")


def read_arrays(source: str) -> Mapping[str, np.ndarray]:
    """All arrays of a file by name, one-dimensional where they are columns.

    Raises
    ------
    InvalidInput
        For a MAT file of version 7.3, and where the package that reads TDMS is missing.
    OSError, ValueError, zipfile.BadZipFile
        If the file cannot be read.
    """
    if source.endswith(".npz"):
        with np.load(source, allow_pickle=False) as archive:
            return {name: np.atleast_1d(archive[name]) for name in archive.files}
    return _from_mat(source) if source.endswith(".mat") else _from_tdms(source)


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
    return {k: np.atleast_1d(v) for k, v in found.items() if not k.startswith("__")}


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
