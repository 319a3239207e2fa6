"""Where fitted runs do not show a lack no size can be found, and the reader is told which would."""

from types import SimpleNamespace

import numpy as np
import pytest

from simpter_hybrid.identification.fitting.floor import Floors
from simpter_hybrid.identification.reporting import hardly_fitted
from simpter_hybrid.identification.reporting.hardly_fitted import hardly_fitted_sentence
from simpter_hybrid.identification.tracing.limits import REPEATED


def found(fitted, select, kind="unknown", cost=1.0):
    model = SimpleNamespace(
        residuals=np.full(100, fitted), select_error=select, cost=1.0,
        by_experiment={"slow": 1.1, "small strokes": select},
    )  # fmt: skip
    presliding = SimpleNamespace(
        candidate=SimpleNamespace(listed_as="presliding"), gain=0.94, fit=SimpleNamespace(cost=cost)
    )
    done = SimpleNamespace(
        refitted=model, floor=1.0, verdict=SimpleNamespace(kind=kind),
        rounds=(SimpleNamespace(trials=(presliding,)),),
    )  # fmt: skip
    return SimpleNamespace(
        search=done,
        floors=Floors(1.0, 1.0, 1.0),
        split=SimpleNamespace(select=[]),
        limits=REPEATED,
    )


def test_the_runs_that_show_it_and_what_would_help_there():
    said = hardly_fitted_sentence(found(1.06, 16.0))
    assert "1.06 times the floor, 16.00 times" in said
    assert "kind (small strokes) fit as well" in said
    assert said.endswith("presliding, of a size that nothing has fitted, lowers the error by 94 %.")


def test_what_was_fitted_is_not_offered():
    assert "presliding" not in hardly_fitted_sentence(found(1.06, 16.0, cost=0.5))


@pytest.mark.parametrize(
    ("fitted", "select", "kind"),
    [
        (8.0, 16.0, "unknown"),
        (2.5, 56.0, "unknown"),
        (1.0, 1.5, "unknown"),
        (1.06, 16.0, "form incomplete"),
    ],
)
def test_where_fits_can_tell_nothing_is_said(fitted, select, kind):
    assert hardly_fitted_sentence(found(fitted, select, kind)) == ""


def test_of_one_run_alone_it_is_said_when(monkeypatch):
    monkeypatch.setattr(hardly_fitted, "alone_when", lambda _: "run 5, most of it from 3 to 4 s")
    said = hardly_fitted_sentence(found(1.06, 16.0))
    assert "of these one alone leaves more than noise (run 5, most of it from 3 to 4 s)" in said
    assert "let a run like it fit as well" in said
