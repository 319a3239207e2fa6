"""A wave that does not come again along the way is much like a step, and leaves what that does."""

from dataclasses import replace

from evidence import FLOOR, depends, judged, trial

from simpter_hybrid.identification.tracing.limits import SINGLE_AXIS


def test_a_wave_that_leaves_its_own_dependence_and_does_not_come_again_is_none():
    """However near a floor that is known roughly: a step of friction is half a wave."""
    wave = trial("wave", 1.1, "wave")
    candidate = replace(wave.candidate, coordinates=("place",), again=100.0)
    wave = replace(wave, candidate=candidate, fit=replace(wave.fit, values={"wave.number": 60.0}))
    shown = [depends("place", 0.8)]
    asked = {"ratio": 1.6, "limit": SINGLE_AXIS}
    assert judged([wave], shown, [], FLOOR, **asked).kind == "effect"
    left = judged([wave], shown, [depends("place", 0.6)], FLOOR, **asked)
    assert (left.kind, left.coordinates) == ("unknown", ("place",))
    nearly_all = replace(wave, share=0.995)
    kept = judged([nearly_all], shown, [depends("place", 0.6)], FLOOR, **asked)
    assert kept.kind in ("effect", "form incomplete")
    often = replace(wave, fit=replace(wave.fit, values={"wave.number": 140.0}))
    assert judged([often], shown, [depends("place", 0.6)], FLOOR, **asked).kind != "unknown"


def test_one_that_does_not_come_again_excludes_nothing_that_helps():
    """A coast-down of 33 turns had a wave of 46, and drag that explained half as much."""
    wave = trial("wave", 1.0, "wave")
    candidate = replace(wave.candidate, coordinates=("place",), again=100.0)
    drag = trial("drag", 1.15, "drag")
    asked = {"ratio": 1.3, "limit": SINGLE_AXIS}
    shown = [depends("place", 0.8)]
    kinds = {}
    for number in (60.0, 140.0):
        once = replace(
            wave, candidate=candidate, fit=replace(wave.fit, values={"wave.number": number})
        )
        kinds[number] = judged([once, drag], shown, [], FLOOR, **asked).kind
    assert kinds == {60.0: "cannot be told apart", 140.0: "effect"}
