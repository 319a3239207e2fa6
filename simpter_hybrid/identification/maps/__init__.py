"""Maps and models that come with the program, and which of them a recording takes."""

from __future__ import annotations

from pathlib import Path

from ...problems import InvalidInput, Problem

MAPS = Path(__file__).parent
MODELS = MAPS.parent / "models"


def find_model(name: str) -> Path:
    """A model's file, or the shipped one of that name.

    Raises
    ------
    InvalidInput
        If there is neither.
    """
    return _find("--model", name, MODELS)


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
    for file in (
        model.with_name(f"{model.stem}_map.toml"),
        Path(recording).parent / "map.toml",
        MAPS / f"{model.stem}.toml",
    ):
        if file.is_file():
            return file
    right = "--map FILE.toml: channel -> column, unit, sign, role"
    raise InvalidInput([Problem("--map", "", "no map of the recording", "none", right)])


def _find(option: str, name: str, folder: Path) -> Path:
    file = Path(name)
    if file.is_file():
        return file
    shipped = folder / f"{name}.toml"
    if shipped.is_file():
        return shipped
    known = ", ".join(sorted(f.stem for f in folder.glob("*.toml")))
    right = f"a TOML file, or one of {known}"
    raise InvalidInput([Problem(option, "", "no such file", name, right)])
