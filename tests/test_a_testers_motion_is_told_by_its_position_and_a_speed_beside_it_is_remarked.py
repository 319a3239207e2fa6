"""Of a tester's position and speed one tells the motion; the other is no mistake of the map."""

from types import SimpleNamespace

from simpter_hybrid.identification.axis.recorded import unused
from simpter_hybrid.identification.recordings.channel_map import ChannelMap


def test_how_the_speed_would_be_taken_is_said():
    names = ("position", "speed", "force")
    channels = {n: ChannelMap(n, n, "1", "input") for n in names}
    (found,) = unused(SimpleNamespace(channels=channels), ("position", "pressure", "force"))
    assert found.value == "speed"
    assert found.right == "the map without the position, if the speed is the surer of the two"
