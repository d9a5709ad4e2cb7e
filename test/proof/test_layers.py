"""The library's folders lie on each other as DESIGN.md lists them: each uses those above it."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from refreshing.keywords import names_in, public_headers
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
        if target.parts[0] != "mavlink" and order.index(path.parts[0]) < order.index(target.parts[0])
    ]


def test_list_names_every_folder_and_each_file_is_in_one():
    assert sorted(folders()) == sorted(path.name for path in INSIDE.iterdir())


def test_no_folder_uses_one_below_it():
    assert misplaced(uses(), folders()) == []
    upwards = (Path("base/Clock.h"), Path("link/Link.h"))
    assert misplaced([upwards, upwards[::-1]], folders()) == ["base/Clock.h uses link/Link.h"]


def test_vendored_headers_are_included_in_one_place():
    """Whatever else names MAVLink's types includes that, and no public header does."""
    vendored = {str(path) for path, target in uses() if target.parts[0] == "mavlink"}
    assert vendored == {"base/MavlinkHeaders.h"}
    named = {INSIDE / path for path, target in uses() if str(target) == "base/MavlinkHeaders.h"}
    assert named and not named & {*public_headers()}


def test_what_no_sketch_may_name_is_in_namespace_detail():
    """A sketch's are the headers that MavMission.h and those beside it include; of others it gets macros alone."""
    headers = {path for path in INSIDE.rglob("*.h") if path.relative_to(INSIDE).parts[0] != "mavlink"}
    sketches = {name for path in headers & {*public_headers()} for name in names_in(path.read_text())}
    inner = {name for path in headers - {*public_headers()} for name in names_in(path.read_text())}
    assert {"MissionClient", "waypoint", "Accepted"} <= sketches and "FrameParser" not in sketches
    assert {name for name in inner - sketches if not name.isupper()} == set()


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


SERVICES = ("service", "files", "telemetry", "payload", "steering")
PORTS = {"Port.h", "CommandPort.h", "PlanPort.h", "Operation.h"}
# What calls a MissionClient and a Steering, as a sketch does.
AS_A_SKETCH = {"Flight", "FlightWords", "SteeredFlight"}


def test_services_see_the_ports_of_the_client_alone():
    sources = [source for folder in SERVICES for source in sorted((INSIDE / folder).glob("*.cpp"))]
    seen = seen_of_the_client(sources)
    assert sorted(seen) == sorted(source.stem for source in sources)
    assert {name for name, headers in seen.items() if "MissionClient.h" in headers} == AS_A_SKETCH
    assert set().union(*(headers for name, headers in seen.items() if name not in AS_A_SKETCH)) == PORTS
    own = {target.name for path, target in uses() if path.parts[0] in SERVICES and target.parts[0] == "client"}
    assert own == {"MissionClient.h", *PORTS}
    assert "Client.h" in seen_of_the_client([INSIDE / "client" / "Clear.cpp"])["Clear"]


# What makes a command beside the operations, each with one literal number.
ASKING = {"service/LinkDoctor.cpp", "service/MessageIntervals.cpp", "steering/MovingTarget.cpp"}
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
