import pytest

from simpter_hybrid.sweeps.case import Record
from simpter_hybrid.sweeps.design import Design
from simpter_hybrid.sweeps.table import Table


def swept(values: tuple[str, ...]) -> Table:
    design = Design(("device.l",), tuple((v,) for v in values))
    return Table(design, tuple(Record(str(k), {}, "finished", "") for k in range(len(values))))


def test_a_column_of_several_units_is_not_mixed() -> None:
    assert swept(("1 m", "0.5 m")).column("device.l").tolist() == [1.0, 0.5]
    with pytest.raises(ValueError, match=r"device\.l was given in cm, m"):
        swept(("1 m", "50 cm")).column("device.l")
