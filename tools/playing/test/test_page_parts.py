"""Parts of the page by themselves, in Node.js: addresses, files that are no sketch, what came of an event, and how a
plan is given to PlanConsole."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import Any

import pytest

from building import build_sketch

pytestmark = pytest.mark.slow

# As much of a page as an event log needs.
LIST = """
globalThis.document = { createElement: () => ({
  textContent: "", append(words) { this.textContent += words; }, remove() {},
}) };
const list = { children: [], prepend(one) { this.children.unshift(one); }, replaceChildren() { this.children = []; } };
"""
FRAME = '{ way: "%s", text: "%s", lost: "%s", again: %s, began: %s }'


def ran(folder: Path, imports: str, script: str, *arguments: str | Path) -> Any:
    """What `out` is behind a script, to which these names are imported from these files of the page."""
    lines = "".join(f"import {{ {name} }} from {json.dumps((folder / file).as_uri())};"
                    for name, file in (one.split("@") for one in imports.split()))  # fmt: skip
    whole = f"import {{ readFileSync }} from 'node:fs';{lines} let out;{script};" \
        "process.stdout.write(JSON.stringify(out));"  # fmt: skip
    command = ["node", "--input-type=module", "-e", whole, "-", *map(str, arguments)]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout)


def test_names_that_every_object_has_and_places_off_the_earth_are_no_part_of_an_address(folder):
    hashes = ["#constructor=1&toString=2&__proto__=3&loss=4", "#draw=900000001.0.20", "#draw=0.-1800000001.20r"]
    script = f"out = {json.dumps(hashes)}.map((hash) => stateOf(hash, []))"
    objects, *places = ran(folder, "stateOf@address.js", script)
    assert objects["complaints"] == ["constructor=1", "toString=2", "__proto__=3"] and objects["state"]["loss"] == 4
    assert all(len(place["complaints"]) == 1 and place["state"]["draw"] == "" for place in places)


def test_an_elf_that_is_none_or_was_cut_off_is_called_so(folder, tmp_path):
    whole = build_sketch("UploadWithProgress").elf.read_bytes()
    files = {"empty.elf": b"", "text.elf": b":00000001FF\n", "short.elf": whole[:40], "half.elf": whole[:50_000]}
    for name, data in files.items():
        (tmp_path / name).write_bytes(data)
    script = """out = process.argv.slice(2).map((file) => {
      try { return exampleOf(file, new Uint8Array(readFileSync(file))).name; } catch (error) { return error.message; }
    })"""
    said = ran(folder, "exampleOf@own.js", script, *(tmp_path / name for name in files))
    assert said == ["it is no ELF file", "it is no ELF file", *["the .elf file was cut off"] * 2]


def logged(folder: Path, script: str) -> list[str]:
    script = f"{LIST} const log = new EventLog(list); {script}; out = list.children.map((one) => one.textContent)"
    return ran(folder, "EventLog@event_log.js", script)


def heard(*frames: tuple[str, str, str, bool, float]) -> str:
    made = (FRAME % (way, text, lost, json.dumps(again), began) for way, text, lost, again, began in frames)
    return f"log.hear([{', '.join(made)}])"


def test_the_headline_says_whether_the_sketch_has_printed_and_where_its_buttons_are(folder):
    seen = [{"prints": True}, {"prints": True, "said": "well"}, {"waits": True}, {"ordered": True},
            {"waits": True, "flown": True}]  # fmt: skip
    known = {"name": "My", "autopilot": "PX4", "heard": True}
    script = f"out = {json.dumps([{**known, **one} for one in seen])}.map(headline)"
    assert ran(folder, "headline@headline.js", script) == [
        "My runs beside PX4, and has printed nothing yet.",
        "My runs beside PX4: the serial monitor has what it prints.",
        "My runs beside PX4. Its buttons stand under “Inside the Mega”: a press holds one down, a second lets it go.",
        "My runs beside PX4. It waits for an order: the button that sends one stands under “Inside the Mega”.",
        "The flight is over.",
    ]  # fmt: skip


def test_what_is_lost_is_told_however_many_items_were_sent_before(folder):
    items = [(">", f"MISSION_ITEM_INT {seq}: NAV_WAYPOINT", "", False, 2 + seq / 10) for seq in range(9)]
    frames = [(">", "MISSION_COUNT 9 items", "", False, 1.9), *items, ("<", "MISSION_ACK ACCEPTED", "lost", False, 3.0),
              (">", "MISSION_ITEM_INT 8: NAV_WAYPOINT", "", True, 4.5)]  # fmt: skip
    (told,) = logged(folder, f'log.add({{ at: 1, words: "the Mega is restarted" }}); {heard(*frames)}')
    assert told == ("1.0 s: the Mega is restarted. +0.90 s: the Mega sends MISSION_COUNT 9 items. "
                    "+1.00 s: the Mega sends MISSION_ITEM_INT 0: NAV_WAYPOINT. +2.00 s: lost: MISSION_ACK ACCEPTED. "
                    "+3.50 s: the Mega sends again MISSION_ITEM_INT 8: NAV_WAYPOINT.")  # fmt: skip


def test_a_frame_that_is_to_be_lost_is_waited_for_over_other_events_and_each_event_has_its_end(folder):
    restarted, pulled, told = logged(folder, f"""
      log.add({{ at: 1, words: "the next MISSION_ACK will be lost", awaits: "MISSION_ACK" }});
      log.say("reached 1", 2); log.wait(3.9); log.wait(4.1);
      log.add({{ at: 10, words: "the cable is pulled" }}); log.add({{ at: 12, words: "the Mega is restarted" }});
      {heard(("<", "MISSION_REQUEST 0", "lost", False, 12.5), (">", "COMMAND_LONG", "", False, 13.0))};
      {heard(("<", "MISSION_ACK ACCEPTED", "lost", False, 30.0), (">", "MISSION_ITEM_INT 3", "", True, 31.5))};
      log.say("aboard", 32)""")  # fmt: skip
    assert told == ("1.0 s: the next MISSION_ACK will be lost. +3.10 s: none has come yet: “Restart the Mega” lets the "
                    "sketch begin anew. +29.00 s: lost: MISSION_ACK ACCEPTED. +30.50 s: the Mega sends again "
                    "MISSION_ITEM_INT 3. +31.00 s: the sketch says “aboard”.")  # fmt: skip
    assert pulled == "10.0 s: the cable is pulled. +2.00 s: nothing had come of it until then."
    assert restarted == ("12.0 s: the Mega is restarted. +0.50 s: lost: MISSION_REQUEST 0. +1.00 s: the Mega sends "
                         "COMMAND_LONG.")  # fmt: skip


def test_what_the_mega_sends_into_a_pulled_cable_is_its_answer_and_what_happens_much_later_is_none(folder):
    sent = [(">", "MISSION_COUNT 5 items", "cut", turn > 0, 1.5 + 1.5 * turn) for turn in range(2)]
    (told,) = logged(folder, f"""log.add({{ at: 1, words: "the cable is pulled" }});
      {heard(*sent)}; log.wait(4.5); log.say("landed", 20)""")  # fmt: skip
    assert told == ("1.0 s: the cable is pulled. +0.50 s: the Mega sends MISSION_COUNT 5 items, which is lost. "
                    "+2.00 s: the Mega sends again MISSION_COUNT 5 items, which is lost.")  # fmt: skip


def test_the_lines_of_a_plan_follow_one_another_as_they_are_stored(folder):
    lines = ["QGC WPL 110", "home", *(f"item {turn}" for turn in range(1, 6))]
    plan = json.dumps({"waypoints": "\n".join(lines) + "\n", "places": [f"my.plan:{turn}: item" for turn in range(5)]})
    stored, refused = ran(folder, "Dropped@dropped.js", f"""
      const typed = (answers) => {{
        const given = [];
        const dropped = new Dropped({plan}, (text) => given.push(text), []);
        for (const answer of answers) dropped.hear(answer);
        return [given, dropped.step, dropped.why];
      }};
      out = [typed(["1\\n", "2\\n3\\n", "4\\n5\\n", "stored: list prints it\\n"]),
        typed(["1\\n", "item 3: more items than there is room for\\n",
          "nothing was loaded; further lines are ignored, up to end\\n"])];
    """)  # fmt: skip
    given, step, _ = stored
    assert "".join(given) == "load\n" + "".join(f"{line}\n" for line in lines) + "end\nupload\n" and step == 1
    assert given[:4] == ["load\n", "QGC WPL 110\nhome\nitem 1\nitem 2\n", "item 3\n", "item 4\n"]
    given, _, why = refused
    assert given[-1] == "end\n" and "item 4\n" not in given
    assert why == "my.plan:2: item: more items than there is room for"
