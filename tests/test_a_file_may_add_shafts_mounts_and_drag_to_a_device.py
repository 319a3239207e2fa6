"""[[device.with]] in a scenario file: the devices of Python, written back, problems named."""

import pytest
from devices_for_tests import Block, always_on

from simpter_hybrid.devices.extended import with_drag, with_mount, with_shaft
from simpter_hybrid.devices.one_axis import LinearAxis
from simpter_hybrid.devices.testbed import Testbed
from simpter_hybrid.engine import simulate
from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.files.scenario_text import resolve
from simpter_hybrid.identification.rigs.corrected import with_parameters
from simpter_hybrid.problems import InvalidInput
from simpter_hybrid.scenario import Scenario

FILE = """
[run]
t_end = "0.5 s"
[device]
kind = "testbed"
inertia = "0.1 kg*m^2"
[[device.with]]
kind = "drag"
clutch = 1
name = "bearing"
[[device.with]]
kind = "shaft"
clutch = 1
name = "gear"
inertia = "0.02 kg*m^2"
stiffness = "40 N*m/rad"
[start]
coordinates = ["0.2 rad", "0 rad"]
speeds = ["3 rad/s", "0 rad/s"]
commands = ["5 V", "1 V"]
excitations = ["5 V", "1 V"]
[[clutches]]
torque = { kind = "linear", rated = "1 N*m" }
[[clutches]]
threshold = "-1 V"
time_constant = "0 s"
torque = { kind = "coulomb-viscous", coulomb = "0.5 N*m" }
"""


def test_a_file_makes_the_device_that_python_makes():
    made = parse(FILE).device
    same = with_shaft(with_drag(Testbed(0.1), 0, "bearing"), 0, 0.02, 40.0, name="gear")
    assert made.coordinates == same.coordinates == ("rotor", "gear")
    assert made.surfaces == same.surfaces == ("clutch 1", "bearing")
    assert made.parameters() == same.parameters()


def test_what_was_added_is_written_back_to_the_same_bytes():
    scenario = parse(FILE)
    text = resolve(scenario).text
    assert resolve(parse(text)).text == text
    assert simulate(parse(text)).end.tobytes() == simulate(scenario).end.tobytes()


def test_fitted_numbers_of_an_extended_device_are_written_as_they_are_now():
    fitted = {"device.inertia": 0.13, "device.gear_stiffness": 55.0}
    text = resolve(with_parameters(parse(FILE), fitted)).text
    values = parse(text).device.parameters()
    assert (values["inertia"], values["gear_stiffness"]) == (0.13, 55.0)


def test_what_cannot_be_added_is_said_with_everything_else():
    wrong = FILE.replace('kind = "shaft"', 'kind = "rope"').replace("0.02 kg*m^2", "2 N")
    wrong = wrong.replace('"1 N*m"', '"1 s"')
    with pytest.raises(InvalidInput) as found:
        parse(wrong)
    keys = ["device.with.1.kind", "device.with.1.inertia", "clutches.0.torque.rated"]
    assert [p.path for p in found.value.problems] == keys


@pytest.mark.parametrize("name", ["rotor", "bearing", "no name"])
def test_a_name_that_is_taken_or_none_is_refused(name):
    with pytest.raises(InvalidInput, match=r"device\.with\.1: the shaft cannot be added \(name"):
        parse(FILE.replace('name = "gear"', f'name = "{name}"'))


def test_a_mount_under_a_sliding_clutch_has_a_mass():
    made = with_mount(LinearAxis(2.0), 0, 0.5, 100.0)
    assert made.coordinate_dimensions == ("length", "length")
    text = FILE.replace('"testbed"\ninertia = "0.1 kg*m^2"', '"linear-axis"\nmass = "2 kg"')
    text = text.replace('"linear", rated', '"coulomb-viscous", coulomb')
    text = text.replace("0.02 kg*m^2", "0.5 kg").replace("N*m/rad", "N/m")
    text = text.replace(" rad/s", " m/s").replace(" rad", " m").replace("N*m", "N")
    assert "gear_inertia" in parse(text).device.parameters()


def test_two_devices_made_from_one_do_not_share_their_sources():
    made = [with_mount(Block(0.1), 0, 0.2, 30.0), with_shaft(Block(0.1), 0, 0.2, 30.0)]
    runs = [Scenario("x", d, (always_on(5, 6),), (0.2, 0.2), (0.0, 0.0), 1.0) for d in made]
    held = {"command": (1.0,), "excitation": (1.0,)}
    ends = [simulate(run.replace(**held)).end[0] for run in runs]
    again = with_mount(Block(0.1), 0, 0.2, 30.0)
    assert simulate(runs[0].replace(device=again, **held)).end[0] == ends[0] != ends[1]


MODULE = """
from simpter_hybrid.devices.testbed import Testbed


def heavy(times=1.0):
    return Testbed(0.1 * times)
"""


def test_a_device_that_a_function_made_is_written_with_the_numbers_that_it_has_now(tmp_path):
    (tmp_path / "heavy_testbed.py").write_text(MODULE)
    text = FILE.replace('"testbed"\ninertia = "0.1 kg*m^2"', '"heavy_testbed:heavy"\ntimes = 2.0')
    scenario = parse(text, folder=tmp_path)
    assert scenario.device.parameters()["inertia"] == 0.2
    same = parse(resolve(scenario).text, folder=tmp_path)
    assert same.device.parameters() == scenario.device.parameters()
    fitted = with_parameters(scenario, {"device.inertia": 0.23, "device.gear_stiffness": 7.0})
    again = parse(resolve(fitted).text, folder=tmp_path)
    assert again.device.parameters() == fitted.device.parameters()


ARM = """
[run]
t_end = "1 s"
[device]
kind = "planar-arm"
[[device.with]]
kind = "shaft"
clutch = 4
inertia = "0.1 kg*m^2"
[start]
coordinates = ["0.3 rad", "0.9 rad", "-0.4 rad"]
[clutch]
torque = { kind = "linear", rated = "1 N*m" }
"""


def test_a_shaft_behind_a_clutch_whose_map_depends_on_the_pose_is_refused():
    with pytest.raises(InvalidInput) as found:
        parse(ARM)
    (problem,) = found.value.problems
    assert "only constant clutch maps" in problem.what
