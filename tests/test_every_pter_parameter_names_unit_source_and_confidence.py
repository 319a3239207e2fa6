"""The parameter file is complete, readable in SI, and its link set gives alpha, beta, gamma."""

import tomllib
from pathlib import Path

import pytest

from derivations import lagrangian, symbols
from simpter_hybrid import devices
from simpter_hybrid.units import parse_quantity

TABLE = tomllib.loads(
    (Path(devices.__file__).parent / "pter_parameters.toml").read_text(encoding="utf-8")
)


def entries(table, path=""):
    if "value" in table:
        yield path, table
        return
    for key, inner in table.items():
        yield from entries(inner, f"{path}.{key}".lstrip("."))


ENTRIES = dict(entries(TABLE))


@pytest.mark.parametrize("path", ENTRIES)
def test_the_entry_is_complete(path):
    entry = ENTRIES[path]
    assert entry["kind"] in ("printed", "inferred")
    assert entry["source"]
    assert entry["confidence"]
    listed = entry["value"] if isinstance(entry["value"], list) else [entry["value"]]
    values = [parse_quantity(text, entry["dimension"]) for text in listed]
    if "range" in entry:
        low, high = (parse_quantity(text, entry["dimension"]) for text in entry["range"])
        assert all(low <= value <= high for value in values)


def si(path):
    return parse_quantity(ENTRIES[path]["value"], ENTRIES[path]["dimension"])


def test_the_link_set_gives_alpha_beta_and_gamma():
    lumped = lagrangian.lumped_inertia(lagrangian.from_links().mass_matrix)
    links = {name.split(".")[1] for name in ENTRIES if name.startswith("links.")}
    values = {name: si(f"links.{name}") for name in links} | {"l_a": si("linkage.l_a")}
    for symbol, expression in lumped.items():
        number = expression.subs({s: values[s.name] for s in expression.free_symbols})
        # sums of five products of decimal numbers
        assert float(number) == pytest.approx(si(f"linkage.{symbol.name}"), rel=1e-14)


def test_the_mass_matrix_is_positive_definite_over_the_whole_range():
    def bounds(name):
        entry = ENTRIES[f"linkage.{name}"]
        return [parse_quantity(text, entry["dimension"]) for text in entry["range"]]

    least = 4.0 * bounds("alpha")[0] * bounds("beta")[0]
    assert max(gamma**2 for gamma in bounds("gamma")) < least
    assert {symbols.ALPHA.name, symbols.BETA.name, symbols.GAMMA.name} <= set(TABLE["linkage"])
