"""An inertia is about some axis: what takes it says which, and a list of parts tells it."""

import json

from simpter_hybrid.cli import main


def test_a_key_is_told_with_its_unit_and_its_meaning(capsys):
    assert main(["list", "--parts", "--json"]) == 0
    keys = {part["name"]: part["keys"] for part in json.loads(capsys.readouterr().out)}
    inertia = next(key for key in keys["device two-link"] if key.startswith("inertia_2"))
    assert inertia.startswith("inertia_2 = an inertia with its unit")
    assert inertia.endswith(": Of each link about its own joint")


def test_files_count_from_one_and_no_key_is_told_otherwise(capsys):
    main(["list", "--parts"])
    keys = [line for line in capsys.readouterr().out.splitlines() if line.startswith("    ")]
    assert len(keys) > 100
    assert not [key for key in keys if "from 0" in key]
