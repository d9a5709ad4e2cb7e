"""A sketch of one's own, as the Arduino IDE compiles it, and the pins that it uses."""

from __future__ import annotations

import json
import subprocess

import pytest

from building import build_sketch
from simulation.mega import Image

READ = """
import { readFileSync } from "node:fs";
const [elf, hex] = await Promise.all([import(process.argv[1]), import(process.argv[2])]);
const flash = (pieces) => {
  const all = new Uint8Array(0x40000).fill(0xff);
  for (const { address, bytes } of pieces) all.set(bytes, address);
  return Buffer.from(all).toString("base64");
};
const read = elf.readElf(new Uint8Array(readFileSync(process.argv[3])));
const same = flash(read.pieces) === flash(hex.piecesOf(readFileSync(process.argv[4], "latin1")));
process.stdout.write(JSON.stringify({ pass: read.pass, ram: read.ram, same }));
"""
NOT_FOR_A_MEGA = ":020000000C94" + f"{(-(2 + 0x0C + 0x94)) & 0xFF:02X}\n:00000001FF\n"


def test_an_elf_is_read_as_the_hex_that_was_made_of_it(folder):
    built = build_sketch("UploadWithProgress")
    mega = folder / "mega"
    command = ["node", "--input-type=module", "-e", READ, (mega / "elf.js").as_uri(), (mega / "hex.js").as_uri(),
               built.elf, built.hex]  # fmt: skip
    read = json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout)
    passes = Image.load(built.elf).symbol("serialEventRun()").address
    assert read == {"pass": passes, "ram": built.ram, "same": True}


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["hex", "elf"])
def test_a_dropped_sketch_runs_as_it_was_compiled(page, tmp_path, kind):
    built = build_sketch("UploadWithProgress")
    mine = tmp_path / f"mine.{kind}"
    mine.write_bytes((built.hex if kind == "hex" else built.elf).read_bytes())
    page.begin("#example=UploadMission&autopilot=px4")
    page.browser.type("#file", str(mine))
    page.wait_for_text("#console", "aboard: our plan, whole")
    assert page.wait_until_good() == "All 6 items are aboard PX4 as they were meant, and the Mega knows it."
    assert page.notice == f"mine.{kind} runs as it was compiled. The address does not carry it."
    known = f"{built.ram} of 8192 bytes" if kind == "elf" else "not known of a .hex"
    assert page.browser.text("#ram") == known
    page.begin("#example=UploadMission")


@pytest.mark.slow
def test_a_file_that_is_no_sketch_for_a_mega_is_refused_in_words(page, tmp_path):
    page.begin("#example=UploadMission")
    wrong_board = bytearray(build_sketch("UploadWithProgress").elf.read_bytes())
    wrong_board[36] = wrong_board[36] & 0x80 | 5  # the machine of an Uno
    for name, data, words in (
        ("uno.hex", NOT_FOR_A_MEGA.encode(), "it is not for an Arduino Mega 2560"),
        ("uno.elf", bytes(wrong_board), "it is not for an Arduino Mega 2560"),
        ("torn.hex", NOT_FOR_A_MEGA.encode()[:9], "line 1 of the .hex file is damaged"),
    ):
        (tmp_path / name).write_bytes(data)
        page.browser.type("#file", str(tmp_path / name))
        page.wait_for_text("#notice", f"{name} was refused: {words}.")
    assert page.value("document.getElementById('example').value") == "UploadMission"


@pytest.mark.slow
def test_a_button_at_a_pin_starts_the_flight_and_the_led_is_shown(page):
    page.begin("#example=StartButton&autopilot=px4")
    page.browser.wait_for("return document.querySelector('#pins button')")
    page.browser.click("#pins button")  # it stays down
    page.wait_for_text("#console", "flying")
    page.wait_for_text("#outcome", "In flight, in MISSION.")
    page.begin("#example=UploadMission")
    page.wait_until_good()
    page.wait_for_text("#pins", "D13: on")
    page.wait_for_text("#pins", "D13: off")
