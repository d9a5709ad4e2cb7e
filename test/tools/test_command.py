"""A tool that is interrupted by Ctrl-C says so in one line, without a traceback."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys

import pytest

from building import ROOT
from interrupts import can_be_interrupted

PYTHON = "#!/usr/bin/env python3\n"
TOOLS = [file for file in sorted((ROOT / "tools").iterdir())
         if file.is_file() and os.access(file, os.X_OK) and file.read_text().startswith(PYTHON)]  # fmt: skip
# Over in a moment.
SHORT = {"doxygen_comments", "wiring"}


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
