"""A release: what must be right before one is made, and the zip that the Arduino IDE imports.

In the zip is what library.json exports, and of the vendored headers those that the library includes. The
tests and the tools are not: the IDE would copy them into each user's sketchbook, where nothing runs them,
and they need Debian; a clone has them, and the pages for those who change the library.
"""

from __future__ import annotations

import functools
import json
import re
import subprocess
import zipfile
from collections.abc import Iterable
from pathlib import Path

SEMVER = r"\d+\.\d+\.\d+(?:-[0-9A-Za-z.-]+)?"
HEADING = re.compile(rf"^## \[?(Unreleased|{SEMVER})\]?(.*)$", re.M)
DATED = re.compile(r" - \d{4}-\d{2}-\d{2}")
# The same for every zip: its bytes are those of its files and nothing else. The earliest that a zip can say.
NO_DATE = (1980, 1, 1, 0, 0, 0)
PLAIN_FILE = 0o100644
VENDORED = "mavlink"
MESSAGE_HEADER = re.compile(r"mavlink_msg_(\w+)\.h")
MESSAGE_INCLUDE = re.compile(rb'^#include "\./mavlink_msg_(\w+)\.h"\n', re.M)
# Names and fields of all messages, also of those that are left out; the library leaves texts to others.
TABLES = re.compile(rb"^# *define MAVLINK_MESSAGE_(?:INFO|NAMES) .*\n", re.MULTILINE)
FUNCTIONS = re.compile(rb"/\*\*\r?\n \* @brief Pack a .*", re.DOTALL)  # of a message, to the end of its header
# Screenshots are of the playground, which is not in the zip.
# Of the page, and of an upload against time.
SCREENSHOT = re.compile(rb"^!\[[^\]]*\]\([^)]*(?:\.png|upload\.svg|recovered\.svg)\)\n", re.MULTILINE)
UNWANTED = {"__pycache__", ".DS_Store", "Thumbs.db"}


class NotReady(Exception):
    """No release can be made; the text says what to do, a line for each thing."""


def versions(root: Path) -> dict[str, str]:
    """The version that each place says."""

    def said(file: str, pattern: str) -> str:
        match = re.search(pattern, (root / file).read_text(), re.M)
        return match[1] if match else "none"

    return {
        "library.properties": said("library.properties", r"^version=(.*)$"),
        "library.json": str(json.loads((root / "library.json").read_text()).get("version", "none")),
        "src/MavMission.h": said("src/MavMission.h", r'^#define MAVMISSION_VERSION "(.*)"$'),
    }


def problems(root: Path, *, snapshot: bool) -> list[str]:
    """What stands against a release; of a snapshot less is asked."""
    found = versions(root)
    version = found["library.properties"]
    wrong = [f"{file} says version {said}, library.properties {version}: make them the same"
             for file, said in found.items() if said != version]  # fmt: skip
    if not re.fullmatch(SEMVER, version):
        wrong.append(f"library.properties: version={version} is not of the form 1.2.3")
    if not snapshot:
        wrong += problems_of_changelog((root / "CHANGELOG.md").read_text(), version)
        wrong += problems_of_clone(root)
        wrong += problems_of_tags(root, version)
    return [*wrong, *problems_of_examples(root)]


def problems_of_changelog(text: str, version: str) -> list[str]:
    sections = {}
    headings = list(HEADING.finditer(text))
    for heading, behind in zip(headings, [*(one.start() for one in headings[1:]), len(text)], strict=True):
        sections[heading[1]] = (heading[2], re.findall(r"^- \S", text[heading.end() : behind], re.M))
    if "Unreleased" in sections and (version not in sections or sections["Unreleased"][1]):
        return [f"CHANGELOG.md: what is under Unreleased belongs to this release: head it ## [{version}] - and the day"
                " (tools/release --prepare VERSION does)"]  # fmt: skip
    if version not in sections:
        return [f"CHANGELOG.md has no heading ## [{version}]"]
    date, entries = sections[version]
    wrong = []
    if not DATED.fullmatch(date):
        wrong.append(f"CHANGELOG.md: the heading of {version} ends with its day, such as - 2031-04-05")
    if not entries:
        wrong.append(f"CHANGELOG.md says nothing of {version}")
    if [name for name in sections if name != "Unreleased"][0] != version:
        wrong.append(f"CHANGELOG.md: {version} is not the first version there")
    return wrong


def problems_of_clone(root: Path) -> list[str]:
    """A release is made of what is committed."""
    ran = subprocess.run(["git", "status", "--porcelain"], cwd=root, capture_output=True, text=True, check=False)
    if ran.returncode != 0:
        return ["this is no git clone: a release is made from one"]
    return [f"not committed: {line[3:]}" for line in ran.stdout.splitlines()]


def git(root: Path, *words: str) -> list[str]:
    ran = subprocess.run(["git", *words], cwd=root, capture_output=True, text=True, check=False)
    return ran.stdout.split()


def problems_of_tags(root: Path, version: str) -> list[str]:
    """A version is one commit, for ever: registries and users have kept what it was."""
    here = git(root, "tag", "--points-at", "HEAD", "--list", "v[0-9]*")
    wrong = [f"this commit has the tag {tag}, and its version is {version}" for tag in here if tag != f"v{version}"]
    if f"v{version}" not in here and git(root, "tag", "--list", f"v{version}"):
        wrong.append(f"v{version} is another commit's tag: a version that was released is not changed, make a new one")
    return wrong


def problems_of_examples(root: Path) -> list[str]:
    readme = (root / "README.md").read_text()
    wrong = []
    for folder in sorted(path for path in (root / "examples").glob("*/*") if path.is_dir()):
        sketch = f"{folder.relative_to(root)}/{folder.name}.ino"
        if not (root / sketch).is_file():
            wrong.append(f"{folder.name}: Arduino wants {sketch}")
        elif f"({sketch})" not in readme:
            wrong.append(f"README.md does not name {sketch}")
    return wrong


def files_of(root: Path) -> list[Path]:
    """What goes into the zip, in order."""
    found: set[Path] = set()
    export = json.loads((root / "library.json").read_text())["export"]
    for name in export["include"]:
        place = root / name
        found |= {file for file in ([place] if place.is_file() else place.rglob("*"))
                  if file.is_file() and not UNWANTED & set(file.parts) and not file.name.startswith(".")}  # fmt: skip
    excluded = [root / name for name in export.get("exclude", ())]
    found -= {file for file in found if is_left_out(root, file) or any(map(file.is_relative_to, excluded))}
    return sorted(found, key=lambda file: file.relative_to(root).as_posix())


# The vendored headers have a file for each of MAVLink's messages, most of the library's size; the library uses a few.


@functools.cache
def words_of_library(root: Path) -> frozenset[str]:
    sources = (file for file in (root / "src").rglob("*")
               if file.suffix in (".h", ".cpp") and VENDORED not in file.parts)  # fmt: skip
    return frozenset(word for file in sources for word in re.findall(r"\w+", file.read_text()))


def is_used(root: Path, message: str) -> bool:
    """Whether the library names it, as its id or as its type."""
    return not words_of_library(root).isdisjoint({f"MAVLINK_MSG_ID_{message.upper()}", f"mavlink_{message}_t"})


def is_left_out(root: Path, file: Path) -> bool:
    if VENDORED not in file.relative_to(root).parts:
        return False
    message = MESSAGE_HEADER.fullmatch(file.name)
    return file.name == "testsuite.h" or (message is not None and not is_used(root, message[1]))


def content_of(root: Path, file: Path) -> bytes:
    """As it goes into the zip: a page has no screenshots; a vendored header does not include those that are left out
    and has no table of all messages' names, and a message's has no functions, which are most of it; the library uses
    its numbers and its struct."""
    data = file.read_bytes()
    if file.suffix == ".md":
        return SCREENSHOT.sub(b"", data)
    if VENDORED not in file.relative_to(root).parts or file.suffix != ".h":
        return data
    if MESSAGE_HEADER.fullmatch(file.name):
        data = FUNCTIONS.sub(b"", data)
    data = TABLES.sub(b"", data)
    return MESSAGE_INCLUDE.sub(lambda line: line[0] if is_used(root, line[1].decode()) else b"", data)


def write_zip(root: Path, output: Path, files: Iterable[Path]) -> None:
    """One folder, named after the library as the IDE wants it. The same files make the same bytes."""
    (name,) = re.findall(r"^name=(.*)$", (root / "library.properties").read_text(), re.M)
    pack(output, ((f"{name}/{file.relative_to(root).as_posix()}", content_of(root, file)) for file in files))


def write_site(site: Path, output: Path) -> None:
    """The folder of tools/site as an archive, in a folder of its own name. The same files make the same bytes."""
    files = sorted(one for one in site.rglob("*") if one.is_file())
    pack(output, ((f"MavMission-site/{file.relative_to(site).as_posix()}", file.read_bytes()) for file in files))


def pack(output: Path, contents: Iterable[tuple[str, bytes]]) -> None:
    output.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(output, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for name, data in contents:
            info = zipfile.ZipInfo(name, NO_DATE)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.create_system = 3  # Unix, whose permissions these are
            info.external_attr = PLAIN_FILE << 16
            archive.writestr(info, data)


def release(root: Path, folder: Path, *, snapshot: bool = False) -> Path:
    """Make the zip in `folder`; raises NotReady."""
    wrong = problems(root, snapshot=snapshot)
    if wrong:
        raise NotReady("\n".join(wrong))
    version = versions(root)["library.properties"]
    output = folder / f"MavMission-{version}{'-snapshot' if snapshot else ''}.zip"
    write_zip(root, output, files_of(root))
    return output
