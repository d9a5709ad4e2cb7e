"""The library's folders lie on each other as DESIGN.md lists them: each uses those above it, and public headers."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from simulation.firmware import LIBRARY, ROOT
from simulation.host_build import PLACES

INSIDE = LIBRARY / "mavmission"


def folders() -> list[str]:
    """As DESIGN.md lists them, the lowest first."""
    listed = (ROOT / "DESIGN.md").read_text().partition("src/mavmission/\n")[2].partition("simulation/")[0]
    return re.findall(r"^  (\w+)/", listed, re.M)


def uses() -> list[tuple[Path, Path]]:
    """(a file, one of ours that it includes), below src/mavmission; the vendored headers apart."""
    found = []
    for path in sorted(INSIDE.rglob("*.[ch]*")):
        if path.relative_to(INSIDE).parts[0] == "mavlink":
            continue
        for name in re.findall(r'#include "([^"]+)"', path.read_text()):
            target = (path.parent / name).resolve()
            assert target.is_file(), f"{path} includes {name}"
            found.append((path.relative_to(INSIDE), target.relative_to(INSIDE)))
    return found


def misplaced(pairs: list[tuple[Path, Path]], order: list[str]) -> list[str]:
    return [
        f"{path} uses {target}"
        for path, target in pairs
        if len(path.parts) > 1 and len(target.parts) > 1 and target.parts[0] != "mavlink"
        if order.index(path.parts[0]) < order.index(target.parts[0])
    ]


def test_list_names_every_folder():
    assert sorted(folders()) == sorted(path.name for path in INSIDE.iterdir() if path.is_dir())


def test_no_folder_uses_one_below_it():
    assert misplaced(uses(), folders()) == []


def test_vendored_headers_are_included_in_one_place():
    """Whatever else names MAVLink's types includes that, and no public header does."""
    vendored = {str(path) for path, target in uses() if target.parts[0] == "mavlink"}
    assert vendored == {"base/MavlinkHeaders.h"}
    named = {str(path) for path, target in uses() if str(target) == "base/MavlinkHeaders.h"}
    assert not [path for path in named if "/" not in path]


def test_home_is_known_in_one_place():
    """Whether wire item 0 is home, and what follows for the numbers of items. (Personality.h has the rows.)"""
    naming = {str(path.relative_to(INSIDE)) for path in INSIDE.rglob("*.[ch]*") if "kHomeIsItem0" in path.read_text()}
    assert naming == {"autopilot/Personality.h", "plan/ItemNumbers.h"}


def seen_of_the_client(sources: list[Path]) -> dict[str, set[str]]:
    """The headers of client/ that each source includes, or what it includes, as the compiler finds them."""
    words = ["g++", "-MM", "-std=c++11", *PLACES, *map(str, sources)]
    rules = subprocess.run(words, capture_output=True, text=True, check=True).stdout.replace("\\\n", " ")
    return {
        rule.partition(".o:")[0]: set(re.findall(r"/client/(\w+\.h)", rule))
        for rule in rules.splitlines()
    }  # fmt: skip


def test_services_see_the_ports_of_the_client_alone():
    sources = sorted((INSIDE / "service").glob("*.cpp"))
    seen = seen_of_the_client(sources)
    assert sorted(seen) == [source.stem for source in sources]
    assert set().union(*seen.values()) == {"Port.h", "CommandPort.h", "PlanPort.h", "Operation.h"}
    assert "Client.h" in seen_of_the_client([INSIDE / "client" / "Clear.cpp"])["Clear"]


# What makes a command beside the operations, each with one literal number.
ASKING = {"service/LinkDoctor.cpp", "service/MessageIntervals.cpp", "service/MovingTarget.cpp"}
GATE = "client/Command.cpp"
COMMANDING = re.compile(r"mavlink_command_(long|int)_t \w+ = mavlink_|KeyIndex::COMMAND_(LONG|INT)|mavlink_set_mode_t")


def test_what_takes_an_aircraft_or_arms_it_leaves_by_the_gate_alone():
    sources = {str(path.relative_to(INSIDE)): path.read_text() for path in INSIDE.rglob("*.[ch]*")}
    making = {name for name, text in sources.items() if COMMANDING.search(text) and not name.startswith("mavlink/")}
    assert making == {GATE, *ASKING}
    gate = sources[GATE].partition("void Client::Command::send(")[2].partition("\n}\n")[0]
    assert gate.index("sending.guard()") < gate.index("sendMessage(") and sources[GATE].count("sendMessage(") == 1
    asked = [re.findall(r"\bcommand = (\w+);", sources[name]) for name in sorted(ASKING)]
    assert [len(names) for names in asked] == [1] * len(ASKING)
    passing = ["MAV_CMD_COMPONENT_ARM_DISARM", "MAV_CMD_MISSION_START", "MAV_CMD_NAV_TAKEOFF", "MAV_CMD_DO_SET_MODE",
               "MAV_CMD_DO_REPOSITION"]  # fmt: skip
    program = '#include "mavmission/autopilot/Guarded.h"\n#include "mavmission/base/MavlinkHeaders.h"\n' + "".join(
        f'static_assert({no}mavmission::detail::isGuarded({name}), "");\n'
        for no, names in (("!", sum(asked, [])), ("", passing))
        for name in names
    )
    words = ["g++", "-std=c++11", "-fsyntax-only", *PLACES, "-xc++", "-"]
    subprocess.run(words, input=program, text=True, check=True)
