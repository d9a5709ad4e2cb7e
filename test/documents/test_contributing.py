"""Each command of CONTRIBUTING.md is one that there is, and its trace is what it prints."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys

from building import ROOT
from measuring import record

TEXT = (ROOT / "CONTRIBUTING.md").read_text()
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", TEXT, re.M | re.S)  # (language, lines)
COMMANDS = [
    line.partition(" #")[0].strip() for language, lines in BLOCKS if not language for line in lines.splitlines()
]


def test_each_part_of_the_work_has_its_command():
    said = "\n".join(COMMANDS)
    for expected in ("pytest -q -s", "build/trace.py", "--timeline", "tools/measure --only", "-max_total_time=3600",
                     "doxygen docs/Doxyfile", "tools/release"):  # fmt: skip
        assert expected in said


def test_each_command_is_a_program_and_its_files_are_there():
    """The options of tools/ are looked at by test_page_commands.py."""
    for command in COMMANDS:
        words = [word for word in shlex.split(command) if not word.startswith("PYTHONPATH=")]
        assert os.access(ROOT / words[0], os.X_OK) or words[0] in ("doxygen", "git"), words[0]
        for word in words[1:]:
            if re.match(r"(?:test|examples|docs)/", word):
                assert (ROOT / word.partition("::")[0]).exists() or "--timeline" in words, word


def test_named_test_is_there_and_the_named_figure_is_measured():
    (file, name) = re.search(r'"(test/\w+/\w+\.py)::(\w+)"', TEXT).groups()
    assert f"def {name}(" in (ROOT / file).read_text()
    (figure,) = re.findall(r"--only (\w+)", TEXT)
    assert figure in record.load()["figures"]


def test_trace_of_one_run_is_printed():
    (script,) = [lines for language, lines in BLOCKS if language == "python"]
    folders = ":".join(str(ROOT / folder) for folder in ("", "test/support"))
    environment = {**os.environ, "PYTHONPATH": folders}
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment, check=False)
    assert ran.returncode == 0, ran.stderr
    lost = [line for line in ran.stdout.splitlines() if "[lost]" in line]
    assert len(lost) == 1 and "MISSION_ACK ACCEPTED" in lost[0]
    assert "returned Accepted" in ran.stdout
