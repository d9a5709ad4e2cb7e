"""A sketch that is written in the page, compiled by the server beside it."""

from __future__ import annotations

import json
import urllib.error
import urllib.request

import pytest

from building import build_sketch
from examples import sketch_of
from playing.compiling import LONGEST, compiled, errors_in
from playing.serving import Server

SKETCH = """#include <MavMission.h>
#include <MavMissionMonitor.h>
void setup() {
  CONSOLE.begin(115200);
  CONSOLE.println(F("written in the page"));
}
void loop() {}
"""
WRITE = """
const area = document.getElementById("source");
document.getElementById("editor").open = true;
area.value = arguments[0];
document.getElementById("compile").click();
"""
CHOOSE = """
const list = document.getElementById("example");
list.value = "UploadMission";
list.dispatchEvent(new Event("change"));
"""


def asked(server: Server, source: bytes, origin: str | None = None) -> dict:
    headers = {"Origin": origin or server.address.rstrip("/")}
    request = urllib.request.Request(server.address + "compile", source, headers)
    with urllib.request.urlopen(request, timeout=120) as answer:
        return json.load(answer)


def refused(server: Server, source: bytes, origin: str | None = None) -> int:
    with pytest.raises(urllib.error.HTTPError) as error:
        asked(server, source, origin)
    error.value.close()
    return error.value.code


def test_a_page_of_another_host_gets_nothing_compiled(server):
    assert refused(server, SKETCH.encode(), "http://example.com") == 403


def test_a_server_without_a_compiler_and_a_text_that_is_too_long_are_refused(server, folder):
    bare = Server(folder)
    try:
        assert refused(bare, SKETCH.encode()) == 403
    finally:
        bare.close()
    assert refused(server, b" " * (LONGEST + 1)) == 413


@pytest.mark.slow
def test_what_is_compiled_is_what_the_builder_makes_of_the_same_text(server):
    source = sketch_of("UploadMission").read_bytes()
    made, built = asked(server, source), build_sketch("UploadMission")
    assert (made["flash"], made["ram"]) == (built.flash, built.ram)
    assert made["hex"] == built.hex.read_text()


@pytest.mark.slow
def test_a_mistake_is_told_with_its_line():
    wrong = SKETCH.replace("println", "printline")
    ((line, words),) = compiled(wrong)["errors"]
    assert line == 5 and "printline" in words


@pytest.mark.slow
def test_a_sketch_without_a_serial_port_is_compiled_and_one_without_setup_is_told_of():
    assert compiled("void setup() { pinMode(13, OUTPUT); }\nvoid loop() {}\n")["pass"] == 0
    assert compiled("void loop() {}\n")["errors"] == [[None, "nothing defines setup"]]


def test_memory_that_does_not_suffice_is_named():
    said = "avr/bin/ld: address 0x8025e0 of Written.ino.elf section `.bss' is not within region `data'\n"
    assert errors_in(2 * said + "collect2: error: ld returned 1 exit status\n") == [[None, "more RAM than a Mega has"]]


@pytest.mark.slow
def test_a_sketch_is_written_compiled_and_run_in_the_page(page):
    page.begin("#example=UploadMission")
    page.browser.wait_for("return document.getElementById('source').value.includes('returnToLaunch()')")
    page.browser.run(WRITE, SKETCH.replace("println", "printline"))
    page.wait_for_text("#errors", "line 5: ")
    assert page.value("document.getElementById('source').value.slice(document.getElementById('source').selectionStart)"
                      ".startsWith('  CONSOLE.printline')")  # fmt: skip
    page.browser.run(WRITE, SKETCH)
    page.wait_for_text("#console", "written in the page")
    assert page.browser.text("#compiler-says") == "It was compiled, and runs."
    assert page.browser.text("#errors") == ""
    page.wait_for_text("#notice", "your sketch runs")
    page.browser.run(WRITE + CHOOSE, SKETCH)
    assert page.notice == ""
    page.wait_for_text("#notice", "your sketch is compiled: choose it in the list of examples.")
    assert page.browser.text("#compiler-says") == "It was compiled."
    assert page.value("document.getElementById('example').value") == "UploadMission"

    page.browser.run(WRITE, SKETCH.replace("println", "printline"))
    page.wait_for_text("#compiler-says", "It was not compiled.")
    assert page.notice == ""  # what it said is no longer true
    page.begin("#example=UploadMission")
    page.wait_until_good()
    assert page.browser.text("#compiler-says") == "UploadMission runs, and this is what you have written."
    assert "printline" in page.value("document.getElementById('source').value")
    page.browser.run("document.getElementById('source-back').click()")
    page.browser.wait_for("return document.getElementById('source').value.includes('returnToLaunch()')")
