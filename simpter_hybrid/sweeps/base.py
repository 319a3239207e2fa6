"""The scenario that a sweep varies, in a form that can be sent to other processes."""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..files.scenario_file import find_scenario, scenario_of
from ..files.scenario_text import Resolved, resolve
from ..files.tomlfile import parse_toml, read_text
from ..problems import InvalidInput, Problem
from ..scenario import Scenario


@dataclass(frozen=True)
class Base:
    """A scenario's text with the overrides common to all cases.

    Parameters
    ----------
    text : str
        TOML.
    source : str
        Name for messages, without a folder.
    folder : str
        Where files named in the text are looked for.
    overrides : tuple of str
        ``path=value``.
    """

    text: str
    source: str
    folder: str
    overrides: tuple[str, ...] = ()

    def scenario(self, more: Sequence[str] = ()) -> Scenario:
        """The scenario with further overrides.

        Parameters
        ----------
        more : sequence of str
            ``path=value``, after the common ones.

        Raises
        ------
        InvalidInput
        """
        file = parse_toml(self.text, self.source, [*self.overrides, *more])
        if more:
            file.data.pop("inferred", None)  # a label that changes nothing and takes time to check
        return scenario_of(file, Path(self.source).stem, Path(self.folder))

    def data(self) -> dict[str, Any]:
        """What the text says, overrides applied."""
        return parse_toml(self.text, self.source, self.overrides).data


def base_of(scenario: Scenario | str | os.PathLike, overrides: Sequence[str] = ()) -> Base:
    """The base that a name, a path or a Scenario stands for.

    Parameters
    ----------
    scenario : Scenario, str or path
        ``-`` is standard input.
    overrides : sequence of str
        ``path=value``.

    Raises
    ------
    InvalidInput
        If there is no such scenario or it cannot be written to a file of its own.
    """
    if isinstance(scenario, Scenario):
        try:
            resolved = resolve(scenario)
        except ValueError as error:
            right = "parts that can be imported by name"
            raise InvalidInput([Problem(scenario.name, "", str(error), "it", right)]) from None
        if resolved.files:
            what = f"it needs further files ({', '.join(resolved.files)})"
            right = "the path of a scenario file"
            raise InvalidInput([Problem(scenario.name, "", what, "a Scenario", right)])
        return Base(resolved.text, f"{scenario.name}.toml", ".", tuple(overrides))
    file = find_scenario(scenario)
    text, source = read_text(file)
    parse_toml(text, source)  # a file that is no TOML is a problem here as well
    return Base(text, Path(source).name, str(file.parent), tuple(overrides))


def fingerprint(*parts: Any) -> str:
    """SHA-256 of JSON of the parts, 64 hexadecimal digits.

    Parameters
    ----------
    *parts
        What is not JSON counts by its ``str``.
    """
    text = json.dumps(parts, sort_keys=True, ensure_ascii=True, default=str)
    return hashlib.sha256(text.encode()).hexdigest()


def content(resolved: Resolved) -> str:
    """Fingerprint of a scenario written out in full and of the files that it names.

    Parameters
    ----------
    resolved : Resolved
    """
    more = [dict(resolved.imported)] if resolved.imported else []
    return fingerprint(resolved.text, resolved.files, *more)
