"""The API reference is made from the headers by doxygen, and whatever doxygen finds amiss is an error."""

from __future__ import annotations

import subprocess
from pathlib import Path

from building import ROOT

DOXYFILE = ROOT / "docs" / "Doxyfile"


def doxygen(output: Path, **settings: str) -> subprocess.CompletedProcess:
    """By the repository's Doxyfile, with these settings changed."""
    changed = {"OUTPUT_DIRECTORY": str(output), **settings}
    text = DOXYFILE.read_text() + "".join(f"\n{name} = {value}" for name, value in changed.items())
    return subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, capture_output=True, text=True, check=False)


def test_readme_is_a_page_of_it_without_a_warning(tmp_path):
    """The headers: test/tools/test_site.py, whose reference is made by the same file."""
    ran = doxygen(tmp_path, INPUT="README.md")
    assert (ran.returncode, ran.stderr) == (0, "")
    assert (tmp_path / "html" / "index.html").is_file()


def test_member_without_a_comment_is_an_error(tmp_path):
    header = tmp_path / "Bare.h"
    header.write_text("// A header.\n#pragma once\n\n// A thing.\nclass Thing {\n public:\n  int bare();\n};\n")
    ran = doxygen(tmp_path / "out", INPUT=str(header), USE_MDFILE_AS_MAINPAGE="", HAVE_DOT="NO")
    assert ran.returncode != 0
    assert "bare() (function) of class Thing is not documented" in ran.stderr
