"""Benches for tests, and what went over their lines when a test fails.

bench: the firmware with a fake autopilot; a test that asks for it runs under both personalities.
make_bench(...): the same, with the Bench's options. line: the firmware alone on a line where
only the test speaks. personality: the name. Brought into test/conftest.py.
"""

from __future__ import annotations

import pytest

LONGEST_TRANSCRIPT = 120  # lines at its end


@pytest.fixture(params=["ArduPilot", "PX4"])
def personality(request) -> str:
    return request.param


@pytest.fixture
def build_bench(request):
    """Makes a Bench whose transcript is shown when the test fails."""
    from simulation.bench import Bench

    def build(*arguments, **options) -> Bench:
        made = Bench(*arguments, **options)
        request.node.stash.setdefault(BENCHES, []).append(made)
        return made

    return build


@pytest.fixture
def make_bench(build_bench, personality):
    return lambda **options: build_bench(personality, **options)


@pytest.fixture
def bench(make_bench):
    return make_bench()


@pytest.fixture
def line(build_bench):
    return build_bench(None)


@pytest.fixture
def build_service(request):
    """Makes a Service, or a bench of another kind, for an autopilot; its transcript is shown when the test fails."""
    from simulation.service import Service

    def build(*arguments, kind=Service, **options):
        made = kind(*arguments, **options)
        request.node.stash.setdefault(BENCHES, []).append(made)
        return made

    return build


@pytest.fixture
def make_service(build_service, personality):
    return lambda **options: build_service(personality, **options)


@pytest.fixture
def service(make_service):
    return make_service()


BENCHES = pytest.StashKey[list]()


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    report = (yield).get_result()
    if report.when == "call" and report.failed:
        for bench in item.stash.get(BENCHES, []):
            lines = bench.transcript().splitlines()
            report.sections.append(("transcript", "\n".join(lines[-LONGEST_TRANSCRIPT:])))
    if report.when == "teardown" and BENCHES in item.stash:
        del item.stash[BENCHES]  # pytest keeps its items, and these would keep every simulated machine of the run
