"""A version: written wherever it stands, what CHANGELOG.md says of it, and what is left to do behind its zips."""

from __future__ import annotations

import json
import re
from pathlib import Path

from releasing import HEADING, SEMVER, NotReady, git


def notes_of(root: Path, version: str) -> str:
    """What CHANGELOG.md says of a version, without its heading."""
    text = (root / "CHANGELOG.md").read_text()
    headings = list(HEADING.finditer(text))
    for heading, behind in zip(headings, [*(one.start() for one in headings[1:]), len(text)], strict=True):
        if heading[1] == version:
            return text[heading.end() : behind].strip() + "\n"
    return ""


def prepare_version(root: Path, version: str, day: str) -> list[str]:
    """Write the version wherever it stands, and head with it and its day what is under Unreleased; the files that were
    changed. Raises NotReady."""
    if not re.fullmatch(SEMVER, version):
        raise NotReady(f"{version} is not of the form 1.2.3")
    changes = {
        "library.properties": (r"^version=.*$", f"version={version}"),
        "library.json": (r'("version": )"[^"]*"', rf'\g<1>"{version}"'),
        "src/MavMission.h": (r'^#define MAVMISSION_VERSION ".*"$', f'#define MAVMISSION_VERSION "{version}"'),
        "CHANGELOG.md": (r"^## \[?Unreleased\]?.*$", f"## [Unreleased]\n\n## [{version}] - {day}"),
    }
    written = {}
    for file, (pattern, new) in changes.items():
        written[file], found = re.subn(pattern, new, (root / file).read_text(), count=1, flags=re.M)
        if not found:
            raise NotReady(f"{file} has no line like {pattern}")
    if not notes_of(root, "Unreleased").strip():
        raise NotReady("CHANGELOG.md says nothing under Unreleased")
    if notes_of(root, version):
        raise NotReady(f"CHANGELOG.md has a version {version} already")
    for file, text in written.items():
        (root / file).write_text(text)
    return list(written)


def left_to_do(root: Path, version: str) -> list[str]:
    """What a release needs behind this command, and it cannot do."""
    left = []
    if f"v{version}" not in git(root, "tag", "--points-at", "HEAD"):
        left.append(f"git tag -a v{version} -m {version}")
    left.append(f"git push origin v{version}: .github/workflows/release.yml then publishes on GitHub and PlatformIO")
    if "repository" not in json.loads((root / "library.json").read_text()):
        left.append('library.json has no "repository", and url= of library.properties leads elsewhere: name the public'
                    " repository in both before the first release")  # fmt: skip
    left.append("for the first release alone: name the repository to github.com/arduino/library-registry, whose"
                " manager then finds each tag by itself")  # fmt: skip
    return left
