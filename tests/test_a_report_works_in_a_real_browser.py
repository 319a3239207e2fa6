"""Headless Chromium opens the report, moves the slider, and finds nothing to complain about."""

import shutil

import pytest
from sampled_runs import baseline, oscillator

from simpter_hybrid.report.page import write_report

MOVE = """
const slider = document.getElementById("time");
slider.value = arguments[0] === null ? slider.max : arguments[0];
slider.dispatchEvent(new Event("input"));
"""


@pytest.fixture(scope="module")
def browser():
    webdriver = pytest.importorskip("selenium.webdriver", reason="needs selenium (pip)")
    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    driver = shutil.which("chromedriver")
    if chromium is None or driver is None:
        pytest.skip("needs chromium and chromedriver (Debian: chromium, chromium-driver)")
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    service = webdriver.ChromeService(executable_path=driver)
    opened = webdriver.Chrome(options=options, service=service)
    yield opened
    opened.quit()


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> str:
    return write_report(baseline(), tmp_path_factory.mktemp("page") / "report.html").as_uri()


def lamps(browser) -> list[str]:
    return [lamp.text for lamp in browser.find_elements("css selector", ".lamp")]


def test_the_slider_moves_the_linkage_and_the_lamps(browser, page):
    run = baseline()
    browser.get(page)
    link = browser.find_elements("css selector", "#view polyline")[-1]
    words = {-1: "backward", 0: "stuck", 1: "forward", 2: "off"}
    browser.execute_script(MOVE, 0)
    pose, start = link.get_attribute("points"), browser.find_element("id", "now").text
    assert lamps(browser) == [words[mode] for mode in run.mode[0].tolist()]
    browser.execute_script(MOVE, None)
    assert link.get_attribute("points") != pose
    assert browser.find_element("id", "now").text != start
    assert lamps(browser) == [words[mode] for mode in run.mode[-1].tolist()]
    assert browser.get_log("browser") == []


def test_events_can_be_visited_and_asked_about(browser, page):
    run = baseline()
    browser.get(page)
    browser.execute_script("document.querySelectorAll('.goto')[2].click()")
    assert f"{run.events[2].t:.4f}" in browser.find_element("id", "now").text
    assert run.events[2].kind in browser.find_element("id", "happening").text
    browser.execute_script("document.querySelectorAll('.why')[2].click()")
    assert "Why now" in browser.find_element("css selector", ".events").text
    assert browser.get_log("browser") == []


def test_a_device_without_a_tip_is_shown_on_a_scale(browser, tmp_path):
    browser.get(write_report(oscillator(), tmp_path / "report.html").as_uri())
    dot = browser.find_element("css selector", "#view circle")
    browser.execute_script(MOVE, 0)
    at = dot.get_attribute("cx")
    browser.execute_script(MOVE, None)
    assert dot.get_attribute("cx") != at
    assert lamps(browser) == ["stuck"]
    assert browser.get_log("browser") == []
