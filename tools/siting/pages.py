"""What Zensical reads: the documents under the paths that they have here, so that their links hold, and a page for each
example, in the order of README.md."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

from building import ROOT
from examples import example_folders, sketch_of

TEXTS = ("README.md", "DESIGN.md", "CONTRIBUTING.md", "SECURITY.md", "CHANGELOG.md")
SKETCH = re.compile(r"examples/[\w.]+/(\w+)/\1\.ino")
# A workflow's picture is at the host of the repository, above its files.
BADGES = re.compile(r"^\[!\[[^]]*\]\(\.\./\.\./actions/.*\n+", re.M)
PLAYGROUND = "playground/index.html"
REFERENCE = "reference/index.html"


def for_the_site(text: str) -> str:
    """A document's text: links to a sketch lead to its page."""
    return SKETCH.sub(r"examples/\1.md", BADGES.sub("", text))


def copy_documents(folder: Path) -> None:
    shown = [ROOT / name for name in TEXTS]
    shown += [file for file in (ROOT / "docs").rglob("*") if file.suffix in (".md", ".svg", ".png")]
    for file in shown:
        target = folder / file.relative_to(ROOT)
        target.parent.mkdir(parents=True, exist_ok=True)
        if file.suffix == ".md":
            target.write_text(for_the_site(file.read_text()))
        else:
            shutil.copyfile(file, target)


def examples() -> list[tuple[str, list[str]]]:
    """By the folders of examples/, in the order of README.md's table: 01.First is First."""
    groups: dict[str, list[str]] = {}
    row = r"^\| \[\w+\]\(examples/\d+\.(\w+)/(\w+)/"
    for group, name in re.findall(row, (ROOT / "README.md").read_text(), re.M):
        groups.setdefault(group, []).append(name)
    return list(groups.items())


def example_page(name: str) -> str:
    code = sketch_of(name).read_text()
    runs = f"[Run it in the browser](../{PLAYGROUND}#example={name})\n\n" if name in example_folders() else ""
    return f"# {name}\n\n{runs}```cpp\n{code}```\n"


def write_examples(folder: Path) -> None:
    (folder / "examples").mkdir(parents=True, exist_ok=True)
    for _, names in examples():
        for name in names:
            (folder / "examples" / f"{name}.md").write_text(example_page(name))


def title(document: str) -> str:
    (heading, *_) = re.findall(r"^# (.*)$", (ROOT / document).read_text(), re.M)
    return heading


def linked(document: str, folder: str) -> list[str]:
    """The pages of a folder that a document links, in its order, each once, and behind them those that it does not."""
    text = (ROOT / document).read_text()
    text = text.partition("\n## Pages\n")[2] + text  # README.md's list has the better order
    names = [f"{folder}/{name}" for name in re.findall(rf"\({folder}/(\w+\.md)", text)]
    every = sorted(str(file.relative_to(ROOT)) for file in (ROOT / folder).glob("*.md"))
    return list(dict.fromkeys([*names, *every]))


def navigation() -> list[dict[str, Any]]:
    """What stands beside each page."""

    def under(documents: list[str]) -> list[dict[str, str]]:
        return [{title(name): name} for name in documents]

    return [
        {"MavMission": "README.md"},
        {"Examples": [{group: [{name: f"examples/{name}.md"} for name in names]} for group, names in examples()]},
        {"Pages": under(linked("README.md", "docs"))},
        {"API reference": REFERENCE},
        {"Playground": PLAYGROUND},
        {"To change it": under(["DESIGN.md", *linked("DESIGN.md", "docs/design"), "CONTRIBUTING.md", "SECURITY.md",
                                "CHANGELOG.md"])},
    ]  # fmt: skip
