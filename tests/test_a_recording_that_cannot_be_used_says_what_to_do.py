"""Files as people have them: quotes, bytes, two columns of a name, a wrong unit of time."""

import numpy as np
import pytest
from axis_recordings import MAP, MODEL

from simpter_hybrid.files.scenario_file import parse
from simpter_hybrid.identification.benches import bench_of
from simpter_hybrid.identification.fits import check_fits
from simpter_hybrid.identification.recordings.groups import groups_of
from simpter_hybrid.identification.recordings.recording import load_recording
from simpter_hybrid.problems import InvalidInput

HEAD = "take,ms,angle,torque"


def _rows(step=4.0, angle="{a:.4f}", torque="{u:.4f}"):
    waves = [(k, np.sin(0.1 * k)) for k in range(100)]
    return [
        f"{take},{step * k:g},{angle.format(a=10 * w)},{torque.format(u=w)}"
        for take in range(3)
        for k, w in waves
    ]


def _load(folder, content, described=MAP, name="data.csv"):
    (folder / "map.toml").write_text(described, encoding="utf-8")
    data = content if isinstance(content, bytes) else "\n".join(content).encode()
    (folder / name).write_bytes(data)
    return load_recording(folder / name, folder / "map.toml")


def _bench(recording, model=MODEL):
    declared = parse(model)
    check_fits(recording, declared)
    return bench_of(recording, declared, groups_of(recording))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"\x1f\x8b\x08 gzipped", "ends in .gz"),
        (b"\0" * 99, "bytes"),
        ([HEAD + ",angle", *(row + ",1" for row in _rows())], "2 columns of one name"),
        ([HEAD, *_rows(angle='"{a:.1f},5"')], "a decimal point"),
        ([HEAD, *_rows(torque="1e300")], "not a finite number"),
    ],
)
def test_a_file_is_refused_with_what_would_be_right(tmp_path, content, message):
    with pytest.raises(InvalidInput, match=message):
        _load(tmp_path, content)


def test_a_mark_within_quotes_shifts_no_column(tmp_path):
    rows = [f'"a, b",{row}' for row in _rows()]
    found = _load(tmp_path, ["note," + HEAD, *rows])
    plain = _load(tmp_path, [HEAD, *_rows()])
    for run, other in zip(found.runs, plain.runs, strict=True):
        assert np.array_equal(run.channels["torque"], other.channels["torque"])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ([HEAD, *_rows(step=4000.0)], "sampled too slowly"),
        ([HEAD, *_rows(step=0.004)], "unit of time"),
        ([HEAD, *_rows(torque="0")], "torque is the same in every row"),
    ],
)
def test_a_rig_that_nothing_drives_or_hardly_samples_is_refused(tmp_path, content, message):
    with pytest.raises(InvalidInput, match=message):
        _bench(_load(tmp_path, content))


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ('unit = "lbf*in"', 'unit = "kg"', "the unit of a mass"),
        ('unit = "lbf*in"', 'unit = "1"', r"channels\.torque\.unit: plain numbers"),
        ('report = ["take 2"]', 'report = ["take 0"]', "not held out"),
        ('report = ["take 2"]', 'report = ["2"]', r'no group.*got "2"; expected groups.*take 2'),
        ('report = ["take 2"]', "", r"split\.report.*missing or empty.*group.*take 0"),
        (
            'torque]\ncolumn = "torque"\nunit = "lbf*in"',
            'current]\ncolumn = "torque"\nunit = "A"',
            r'channels\.current\.unit.*force-drive takes, got "A".*current-drive',
        ),
    ],
)
def test_a_map_of_another_kind_is_refused(tmp_path, old, new, message):
    with pytest.raises(InvalidInput, match=message):
        _bench(_load(tmp_path, [HEAD, *_rows()], MAP.replace(old, new)))


def test_a_duty_of_an_unknown_supply_is_no_voltage(tmp_path):
    described = MAP.replace('torque]\ncolumn = "torque"\nunit = "lbf*in"',
                            'duty]\ncolumn = "torque"\nunit = "1"')  # fmt: skip
    motor = 'kind = "voltage-drive"\nresistance = "4 ohm"\nconstant = "0.4 N*m/A"'
    model = MODEL.replace('kind = "force-drive"\nconstant = "1 N*m/V"', motor)
    with pytest.raises(InvalidInput, match=r'\.duty: .*volts.*a channel "supply" beside it'):
        _bench(_load(tmp_path, [HEAD, *_rows()], described), model)


def test_friction_that_is_never_on_is_refused(tmp_path):
    recording = _load(tmp_path, [HEAD, *_rows()])
    _bench(recording)
    with pytest.raises(InvalidInput, match=r"clutch\.1\.threshold.*-1 V"):
        _bench(recording, MODEL.replace('threshold = "-1 V"', 'threshold = "0 V"'))


def test_a_record_that_would_be_played_too_coarsely_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match=r"controller\.rate.*10 Hz.*at least the"):
        _bench(
            _load(tmp_path, [HEAD, *_rows()]), MODEL.replace('rate = "500 Hz"', 'rate = "10 Hz"')
        )


@pytest.mark.parametrize("noise", ["0 deg", "-1 deg"])
def test_a_sensor_without_noise_is_refused(tmp_path, noise):
    described = MAP.replace("may_rest = true", f'may_rest = true\nnoise = "{noise}"')
    with pytest.raises(InvalidInput, match="not above zero"):
        _load(tmp_path, [HEAD, *_rows()], described)


def test_a_clock_in_millimetres_is_refused(tmp_path):
    with pytest.raises(InvalidInput, match="the unit of a length"):
        _load(tmp_path, [HEAD, *_rows()], MAP.replace('unit = "ms"', 'unit = "mm"'))


PRESSED = """
[channels.pressure]
column = "press"
unit = "Pa"
sign = 1
role = "input"
"""


@pytest.mark.parametrize("asks", [False, True])
def test_what_presses_nothing_is_remarked(tmp_path, asks):
    rows = [f"{row},{3 + k % 2}" for k, row in enumerate(_rows(angle="{a:.6f}"))]
    recording = _load(tmp_path, [HEAD + ",press", *rows], MAP + PRESSED)
    friction = 'coulomb = "0.2 N*m"'
    pressed = MODEL.replace(friction, friction + ', normal = "0.01 N*m/V"') if asks else MODEL
    said = [remark.what for remark in _bench(recording, pressed).remarks]
    assert said == (
        [] if asks else ["the declared model does not depend on press, which may press"]
    )


def test_a_file_without_a_line_of_names_is_told_to_have_one(tmp_path):
    with pytest.raises(InvalidInput, match=r"line 1 holds numbers and no names.*with columns = "):
        _load(tmp_path, _rows())


def test_a_drive_that_was_set_once_and_holds_may_be_the_same_throughout(tmp_path):
    content = [HEAD, *_rows(torque="2")]
    held = MAP.replace('unit = "lbf*in"', 'unit = "lbf*in"\nheld = "after"')
    assert held != MAP
    _bench(_load(tmp_path, content, held))
