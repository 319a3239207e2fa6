"""Event-driven hybrid simulation of devices with controlled friction.

>>> import simpter_hybrid as sh
>>> trajectory = sh.run(sh.load("line-y24"))
>>> sh.plot(trajectory, "pictures")
>>> print(sh.diagnose("slide.csv", "slide.toml"))
"""

from __future__ import annotations

from typing import Any

__all__ = ["diagnose", "load", "load_run", "plot", "run", "save", "sweep"]


def __getattr__(name: str) -> Any:
    # Lazily: `simpter --help` must not wait for SciPy.
    if name in __all__:
        from . import api

        return getattr(api, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
