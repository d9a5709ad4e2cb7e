"""A tool that is interrupted by Ctrl-C says so in one line, without a traceback."""

from __future__ import annotations

import errno
import os
import re
import signal
import subprocess
import sys

import pytest

from _command import explained
from building import ROOT
from interrupts import can_be_interrupted

PYTHON = "#!/usr/bin/env python3\n"
TOOLS = [file for file in sorted((ROOT / "tools").iterdir())
         if file.is_file() and os.access(file, os.X_OK) and file.read_text().startswith(PYTHON)]  # fmt: skip
# Over in a moment.
SHORT = {"doxygen_comments"}


@pytest.mark.parametrize("tool", [tool for tool in TOOLS if tool.name not in SHORT], ids=lambda tool: tool.name)
def test_tool_expects_an_interruption(tool):
    assert re.search(r"run_command\(main\)|except KeyboardInterrupt", tool.read_text())


def test_interrupted_command_leaves_with_a_line_and_the_status_of_a_shell(tmp_path):
    tool = tmp_path / "one"
    tool.write_text(
        f"import signal, sys\nsys.path.insert(0, {str(ROOT / 'tools')!r})\nfrom _command import run_command\n"
        "def main():\n    print('begun', flush=True)\n    signal.pause()\nrun_command(main)\n"
    )
    with subprocess.Popen([sys.executable, tool], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          preexec_fn=can_be_interrupted) as running:  # fmt: skip
        assert running.stdout.readline() == "begun\n"
        running.send_signal(signal.SIGINT)
        said = running.stderr.read()
    assert (running.returncode, said) == (130, "\ntools/one: interrupted\n")


@pytest.mark.parametrize(
    ("command", "said"),
    [
        (["playground", "--port", "65536"], "argument --port: '65536' is not a number from 0 to 65535"),
        (["site", "--port", "-1"], "argument --port: '-1' is not a number from 0 to 65535"),
        (["demo", "--latency", "slow"], "argument --latency: 'slow' is not a number"),
        (["demo", "--plan", str(ROOT / "docs" / "farm.plan"), "--save", "x.pdf"], "x.pdf: is not a kind of file"),
        (["plan", "check", "x.pdf"], "x.pdf: is not a known kind of file: its name must end in .plan"),
    ],
    ids=lambda part: " ".join(part)[:30] if isinstance(part, list) else "",
)
def test_wrong_argument_is_answered_in_one_line_before_anything_is_done(command, said, tmp_path):
    (tmp_path / "a folder").mkdir()
    name, *words = command
    ran = subprocess.run([ROOT / "tools" / name, *words], cwd=tmp_path, capture_output=True, text=True)
    assert ran.returncode in (1, 2) and said in ran.stderr.splitlines()[-1] and "Traceback" not in ran.stderr
    assert ran.stdout == ""


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (FileExistsError(errno.EEXIST, "File exists", "README.md"), "README.md: it is a file; name a folder"),
        (OSError(errno.EADDRINUSE, "Address already in use"), "that port is in use: choose another one with --port"),
        (PermissionError(errno.EACCES, "Permission denied", "/x"), "/x: Permission denied"),
        (OSError("no more"), "no more"),
    ],
)
def test_error_of_a_file_is_explained(error, said):
    assert explained(error) == said
