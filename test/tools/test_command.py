"""A tool that is interrupted by Ctrl-C says so in one line, without a traceback."""

from __future__ import annotations

import errno
import os
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


@pytest.mark.parametrize("tool", TOOLS, ids=lambda tool: tool.name)
def test_tool_expects_an_interruption(tool):
    assert tool.read_text().endswith("    run_command(main)\n")


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
