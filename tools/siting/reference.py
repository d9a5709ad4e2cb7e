"""The API reference, as doxygen writes it by docs/Doxyfile, with a page of the site's own to begin with."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from building import ROOT

HERE = Path(__file__).resolve().parent


class NoReference(Exception):
    """doxygen finds something amiss; the text is what it says."""


def write_reference(folder: Path) -> None:
    begin = HERE / "reference.md"
    with tempfile.TemporaryDirectory() as place:
        changed = {
            "OUTPUT_DIRECTORY": place,
            "INPUT": f"src {begin}",
            "FILE_PATTERNS": "*.h *.md",
            "USE_MDFILE_AS_MAINPAGE": str(begin),
            "GENERATE_TREEVIEW": "NO",  # a phone has no room for it
            "HTML_EXTRA_STYLESHEET": str(HERE / "reference.css"),
        }
        text = "\n".join([(ROOT / "docs" / "Doxyfile").read_text(), *(f"{name} = {changed[name]}" for name in changed)])
        ran = subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, capture_output=True, text=True, check=False)
        if ran.returncode != 0:
            raise NoReference(ran.stderr.strip())
        shutil.copytree(Path(place) / "html", folder)
    for page in folder.glob("*.html"):
        drop_link_to_nothing(page)


def drop_link_to_nothing(page: Path) -> None:
    """doxygen links the section of the nested classes also where it leaves that out, since none is documented."""
    text = page.read_text()
    if 'name="nested-classes"' not in text:
        page.write_text(re.sub(r'<a href="#nested-classes">[^<]*</a> *(?:&#124;)?', "", text))
