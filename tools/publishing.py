"""A version: written wherever it stands, what CHANGELOG.md says of it, and what is left to do behind its zips."""

from __future__ import annotations

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


def prepare_version(root: Path, version: str, day: str, url: str | None = None) -> list[str]:
    """Write the version wherever it stands, and head with it and its day what is under Unreleased, or what has this
    version already; with a url, write where the repository is. The files that were changed. Raises NotReady."""
    if not re.fullmatch(SEMVER, version):
        raise NotReady(f"{version} is not of the form 1.2.3")
    if url is not None and not re.fullmatch(r"https://[\w./-]+", url):
        raise NotReady(f"{url} is not of the form https://host/owner/MavMission")
    changes = [
        ("library.properties", r"^version=.*$", f"version={version}"),
        ("library.json", r'("version": )"[^"]*"', rf'\g<1>"{version}"'),
        ("src/MavMission.h", r'^#define MAVMISSION_VERSION ".*"$', f'#define MAVMISSION_VERSION "{version}"'),
        ("CHANGELOG.md", rf"^## \[?(?:Unreleased|{re.escape(version)})\]?.*$", f"## [{version}] - {day}"),
    ]
    if url is not None:
        repository = f'"repository": {{ "type": "git", "url": "{url}.git" }},'
        changes += [
            ("library.properties", r"^url=.*$", f"url={url}"),
            ("library.json", r'\n *"repository": .*', ""),
            ("library.json", r'("version": "[^"]*",)', rf"\1\n  {repository}"),
        ]
    if notes_of(root, "Unreleased").strip() and notes_of(root, version):
        raise NotReady(f"CHANGELOG.md has a version {version} already")
    if not (notes_of(root, "Unreleased") + notes_of(root, version)).strip():
        raise NotReady(f"CHANGELOG.md says nothing under Unreleased, nor of {version}")
    written: dict[str, str] = {}
    for file, pattern, new in changes:
        text = written.get(file) or (root / file).read_text()
        written[file], found = re.subn(pattern, new, text, count=1, flags=re.M)
        if not found and new:
            raise NotReady(f"{file} has no line like {pattern}")
    for file, text in written.items():
        (root / file).write_text(text)
    return list(written)


def url_of(root: Path) -> str:
    """Where the library's repository is; "" as long as library.properties says that it has no site yet."""
    (url,) = re.findall(r"^url=(.*)$", (root / "library.properties").read_text(), re.M)
    return url if url.startswith("https://") else ""


def steps(root: Path, version: str) -> list[str]:
    """The three that a person takes behind this command, which cannot."""
    url = url_of(root) or "URL"
    is_tagged = f"v{version}" in git(root, "tag", "--points-at", "HEAD")
    return [
        f"the repository is {url}" if url_of(root) else
        "make a public repository, and say where it is, such as https://github.com/owner/MavMission:\n"
        f"     tools/release --prepare {version} --url URL && git commit -am \"Version {version}\" && tools/release",
        f"{'' if is_tagged else f'git tag -a v{version} -m {version} && '}git push {url} HEAD:main v{version}",
        "publish it: on GitHub .github/workflows/release.yml attaches both zips, and PlatformIO gets the library;\n"
        "     elsewhere attach them to a release by hand, with the text above. Unpack the site's zip on any web\n"
        "     server. Once, name the repository to github.com/arduino/library-registry: the IDE then finds it",
    ]  # fmt: skip
