"""What all tests share; where they find the simulated world, the tools and their helpers is in pytest.ini."""

import gc
import os
import shutil
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent

# What Python has compiled is kept, also where the environment says not to: without it each start of a tool takes
# two seconds. Under build/, so that no folder of sources has it.
sys.dont_write_bytecode = False
sys.pycache_prefix = os.environ["PYTHONPYCACHEPREFIX"] = str(ROOT / "build" / "pycache")
os.environ.pop("PYTHONDONTWRITEBYTECODE", None)

# Tools are started by their first line, and a python3 of pyenv is a script that looks for the right one: three times
# the processor time of a tool that only answers.
PYTHON = Path(sys.base_prefix, "bin", "python3")
if Path(shutil.which("python3") or PYTHON).resolve() != PYTHON.resolve():
    os.environ["PATH"] = f"{PYTHON.parent}:{os.environ['PATH']}"

# Hypothesis would keep its examples beside the sources.
os.environ.setdefault("HYPOTHESIS_STORAGE_DIRECTORY", str(ROOT / "build" / "hypothesis"))

from bench_fixtures import (  # noqa: E402, F401
    bench,
    build_bench,
    build_service,
    line,
    make_bench,
    make_service,
    personality,
    pytest_runtest_makereport,
    service,
)
from scenario_table import pytest_collection_modifyitems, pytest_terminal_summary  # noqa: E402, F401


def pytest_collection_finish():
    """What has been collected stays to the end: the garbage collector need not look through it again and again."""
    gc.freeze()


def pytest_configure(config):
    import cpu_time
    import kept_results
    import sample
    import tables

    for plugin in (sample, tables, cpu_time.CpuTime(config), kept_results.KeptResults(config)):
        config.pluginmanager.register(plugin)
