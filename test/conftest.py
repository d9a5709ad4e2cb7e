"""What all tests share; where they find the simulated world, the tools and their helpers is in pytest.ini."""

import os
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

# Hypothesis would keep its examples beside the sources.
os.environ.setdefault("HYPOTHESIS_STORAGE_DIRECTORY", str(ROOT / "build" / "hypothesis"))

from bench_fixtures import (  # noqa: E402, F401
    bench,
    build_bench,
    build_following,
    build_service,
    build_steered,
    following,
    line,
    make_bench,
    make_following,
    make_service,
    make_steered,
    personality,
    pytest_runtest_makereport,
    service,
    steered,
)
from scenario_table import pytest_collection_modifyitems, pytest_terminal_summary  # noqa: E402, F401


def pytest_configure(config):
    import loss_table
    import tables

    config.pluginmanager.register(tables)
    config.pluginmanager.register(loss_table)
