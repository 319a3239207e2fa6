"""A sweep over two paths, one of them with a single value, is a map whose cells have a width."""

import numpy as np

from simpter_hybrid.plots.sweep import sweep_figures
from simpter_hybrid.sweeps.case import Record
from simpter_hybrid.sweeps.design import Design
from simpter_hybrid.sweeps.table import Table


def test_a_map_of_one_value_along_an_axis_shows_its_cells():
    rows = (("2 kg", "3 N/s"), ("2 kg", "4 N/s"), ("2 kg", "5 N/s"))
    paths = ("device.mass", "loads.0.slope")
    records = tuple(
        Record(str(k), dict(zip(paths, row, strict=True)), "finished", "", 1.0, {"events": k})
        for k, row in enumerate(rows)
    )
    table = Table(Design(paths, rows, (1, 3)), records)
    cells = sweep_figures(table)["maps"].axes[0].collections[0].get_coordinates()
    assert np.ptp(cells[..., 0]) > 0.0
    np.testing.assert_allclose(cells[:, 0, 1], [2.5, 3.5, 4.5, 5.5])
