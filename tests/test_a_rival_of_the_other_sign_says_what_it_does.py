"""What else would do is told as what is named is: with what it does where its size is negative."""

from types import SimpleNamespace as Some

import pytest

from simpter_hybrid.identification.reporting.sentences import doubts


def _trial(name, rise):
    candidate = Some(name=name, family=name, declared=False)
    return Some(candidate=candidate, fit=Some(values={f"{name}.rise": rise}))


@pytest.mark.parametrize(
    ("rise", "said"),
    [(-0.2, "stribeck (here friction rises with speed, to a level) in"), (0.2, "stribeck in")],
)
def test_the_sign_is_that_of_its_own_fit(rise, said):
    best = _trial("bias-force", 0.1)
    verdict = Some(accepted=best, rivals=[_trial("stribeck", rise)], as_well=())
    corrected = Some(effects=[best.candidate])
    done = Some(corrected=corrected, rounds=[Some(verdict=verdict)], verdict=Some(as_well=()))
    (told,) = doubts(Some(search=done))
    assert said in told
