"""An axis has friction, and no clutch that could be off; one that slides does not spin."""

from simpter_hybrid.identification.axis.candidates import axis_candidates, of_axis
from simpter_hybrid.identification.axis.sizes import AxisSizes


def experiments(turning):
    tried = axis_candidates(AxisSizes(1.0, 1.0, 1.0, 1.0, 1.0, turning))
    return {c.name: c.experiment for c in tried}


def test_no_candidate_of_an_axis_asks_for_a_clutch():
    for turning in (False, True):
        asked = experiments(turning)
        assert asked["viscous-drag"]
        words = ("clutch", "excitation", ",.", "  ")
        assert not [n for n, text in asked.items() if any(word in text for word in words)]


def test_what_slides_is_moved_and_what_turns_is_spun():
    text = "Spin at several speeds with all clutches off."
    assert of_axis(text, turning=True) == "Spin at several speeds."
    assert of_axis(text, turning=False) == "Move at several speeds."
    assert not [text for text in experiments(False).values() if "Spin" in text or "turns" in text]
