"""Maps and models that come with the program, and which of them a recording takes."""

from __future__ import annotations

from pathlib import Path

from ...files.scenario_file import SHIPPED
from ...problems import InvalidInput, Problem
from ...reading.reader import one_of

MAPS = Path(__file__).parent
MODELS = MAPS.parent / "models"


def find_model(name: str) -> Path:
    """A model's file, or the shipped model or scenario of that name.

    Raises
    ------
    InvalidInput
        If there is neither.
    """
    return _find("--model", name, MODELS, SHIPPED)


def find_map(name: str | None, recording: str, model: Path) -> Path:
    """The map named; else ``MODEL_map.toml`` beside the model; else ``map.toml`` beside the
    recording; else the shipped one of the model.

    Raises
    ------
    InvalidInput
        If there is none.
    """
    if name is not None:
        return _find("--map", name, MAPS)
    own, beside = model.with_name(f"{model.stem}_map.toml"), Path(recording).parent / "map.toml"
    for file in (own, beside, MAPS / f"{model.stem}.toml"):
        if file.is_file():
            return file
    right = (
        f"{own}, {beside} or --map FILE.toml: channel -> column, unit, sign, role"
        f" (simpter check {recording} prints one to fill in)"
    )
    raise InvalidInput([Problem("--map", "", "no map of the recording", "none", right)])


def _find(option: str, name: str, *folders: Path) -> Path:
    for file in (Path(name), *(folder / f"{name}.toml" for folder in folders)):
        if file.is_file():
            return file
    known = sorted(f.stem for f in folders[0].glob("*.toml"))
    what = "not a file" if Path(name).exists() else "no such file"
    raise InvalidInput([Problem(option, "", what, name, f"a TOML file, or {one_of(known, name)}")])
