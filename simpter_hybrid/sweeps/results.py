"""A sweep's directory: what it was started as, a file a case, never half a file."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from ..problems import InvalidInput, Problem
from .case import Record, record_of

#: A directory is a sweep's if it holds this file.
MARK = "sweep.json"
CASES = "cases"
LOCK = ".lock"
PARTIAL = ".partial"


def write_whole(file: Path, content: bytes) -> None:
    """Write a file that is there whole or not at all, even if the power goes.

    Parameters
    ----------
    file : Path
        In a directory that exists.
    content : bytes
    """
    partial = file.with_name(f".{file.name}.{os.getpid()}{PARTIAL}")
    with open(partial, "wb") as stream:
        stream.write(content)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(partial, file)


def settle(directory: Path) -> None:
    """Make the names in a directory last (where the system lets one ask for it).

    Parameters
    ----------
    directory : Path
    """
    try:
        handle = os.open(directory, os.O_RDONLY)
    except OSError:  # Windows opens no directories
        return
    try:
        os.fsync(handle)
    finally:
        os.close(handle)


class SweepDirectory:
    """The files of a sweep.

    Parameters
    ----------
    path : path
    about : mapping
        What the sweep is; ``sweep.json``.
    """

    def __init__(self, path: str | os.PathLike, about: Mapping[str, Any]) -> None:
        self.path, self._named = Path(path), bool(os.fspath(path))
        self.cases = self.path / CASES
        self.about = about
        self._lock: Any = None

    def check(self) -> None:
        """Refuse a directory that is not this sweep's; nothing is written.

        Raises
        ------
        InvalidInput
        """
        right = "the name of a new directory, or that of this very sweep to go on with it"
        what = self._what_is_wrong()
        if what:
            raise InvalidInput([Problem("--out", "", what, str(self.path), right)])

    def _what_is_wrong(self) -> str:
        if not self._named or "\0" in str(self.path):
            return "not a name"
        if self.path.exists() and not self.path.is_dir():
            return "a file, not a directory"
        if self.path.is_dir() and any(self.path.iterdir()):
            return self._differs()
        above = self.path.absolute()
        while not above.exists():
            above = above.parent
        return "" if above.is_dir() and os.access(above, os.W_OK) else "cannot be written to"

    def _differs(self) -> str:
        """How the sweep in the directory differs from this one; empty if it does not."""
        try:
            found = json.loads((self.path / MARK).read_bytes())
        except FileNotFoundError:
            if self._only_begun():
                return ""
            return f"holds something else than a sweep (no {MARK})"
        except (OSError, ValueError) as error:
            return f"holds a {MARK} that cannot be read ({error})"
        if not isinstance(found, dict):
            return f"holds a {MARK} of something else"
        mine = json.loads(about_text(self.about))
        names = [k for k in mine if found.get(k) != mine[k]]
        if names == ["program"]:
            return "holds this sweep as computed by another version of the program"
        return f"holds a different sweep (other {', '.join(names)})" if names else ""

    def _only_begun(self) -> bool:
        """Whether all in the directory is what a sweep leaves that is killed before its mark."""
        if self.cases.is_dir() and any(self.cases.iterdir()):
            return False
        names = (each.name for each in self.path.iterdir())
        partial = f".{MARK}."
        return all(
            name in (CASES, LOCK) or (name.startswith(partial) and name.endswith(PARTIAL))
            for name in names
        )

    def open(self, scenario_files: Mapping[str, str]) -> None:
        """Make the directory or take it over; clear away what a killed sweep left half written.

        Parameters
        ----------
        scenario_files : mapping of str to str
            Text of what is varied and of the files it names, by name; those are written that are
            not there.

        Raises
        ------
        InvalidInput
            If another process is at work in it.
        """
        self.cases.mkdir(parents=True, exist_ok=True)
        self._lock = _locked(self.path / LOCK)
        if self._lock is None:
            right = "to wait for it, or another directory"
            what = "another process is at work on this sweep"
            raise InvalidInput([Problem("--out", "", what, str(self.path), right)])
        for file in [*self.path.glob(f".*{PARTIAL}"), *self.cases.glob(f".*{PARTIAL}")]:
            file.unlink(missing_ok=True)
        # The mark comes first: what was killed before all are there is known for this sweep.
        content = {MARK: about_text(self.about)} | dict(scenario_files)
        missing = {name: text for name, text in content.items() if not (self.path / name).exists()}
        for name, text in missing.items():
            write_whole(self.path / name, text.encode())
        if missing:
            settle(self.path)

    def close(self) -> None:
        """Let other processes go to work on it."""
        if self._lock is not None:
            # While it is locked: who opened it before finds another file there, or none.
            (self.path / LOCK).unlink(missing_ok=True)
            self._lock.close()
            self._lock = None

    def write(self, results: Iterable[tuple[str, bytes]]) -> None:
        """Keep the results of some cases.

        Parameters
        ----------
        results : iterable of (str, bytes)
            Names of cases, and contents of their files.
        """
        for name, content in results:
            write_whole(self.cases / f"{name}.json", content)
        settle(self.cases)

    def read(self, names: Sequence[str]) -> dict[str, Record]:
        """The records that there are of the cases named; damaged files count as not there.

        Parameters
        ----------
        names : sequence of str
            Of cases.
        """
        there = {entry.name for entry in os.scandir(self.cases)} if self.cases.is_dir() else set()
        found = {}
        for name in dict.fromkeys(names):
            if f"{name}.json" in there:
                record = record_of((self.cases / f"{name}.json").read_bytes())
                if record is not None and record.case == name:
                    found[name] = record
        return found


def about_text(about: Mapping[str, Any]) -> str:
    """The text of ``sweep.json``.

    Parameters
    ----------
    about : mapping
        As for `SweepDirectory`.
    """
    return json.dumps(about, indent=1, sort_keys=True) + "\n"


def _locked(file: Path) -> Any:
    """The file, open and locked for this process; None where another one has locked it.

    The lock is one of the process (not handed on to workers) and goes with it, however it ends.
    """
    while True:
        stream = open(file, "a")  # noqa: SIM115 (open as long as the sweep)
        try:
            import fcntl

            fcntl.lockf(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if os.path.samestat(os.fstat(stream.fileno()), os.stat(file)):
                return stream
        except ImportError:  # Windows: no such lock
            return stream
        except FileNotFoundError:  # whoever had it took it away with the sweep that ended
            pass
        except OSError:
            stream.close()
            return None
        stream.close()
