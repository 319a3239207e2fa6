"""Tables 3 and 4 stand twice, so that the audit of equations needs nothing of the program."""

from derivations.audit import clutch_maps as audit
from simpter_hybrid.reproduce import friction_fits as ours


def test_tables_3_and_4_are_the_same():
    rows = zip(ours.SPEEDS, ours.FITS, ours.TABLE_3, ours.TABLE_4, strict=True)
    for speed, fit, (squares, error), (scaled_squares, scaled_error) in rows:
        *told, squares_told, error_told = audit.TABLE_3[speed]
        assert (*fit, squares, error) == (*told, float(squares_told), float(error_told))
        assert (scaled_squares, scaled_error) == tuple(map(float, audit.TABLE_4[speed]))
    assert len(audit.TABLE_3) == len(audit.TABLE_4) == len(ours.SPEEDS)


def test_so_are_the_excitations_and_the_full_scale():
    assert ours.VOLTS.tolist() == audit.VOLTS
    assert ours.FULL_SCALE == audit.FULL_SCALE
