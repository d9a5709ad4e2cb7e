"""The playground's folder, made once for each worker of the tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from examples import example_folder
from played import Page
from playing import make_folder, sketches
from playing.browser import Browser
from playing.compiling import LONGEST, compiled
from playing.serving import Server

FEW = ("UploadMission", "StartMission")  # the examples that the page has in tools/test


def pytest_itemcollected(item):
    """What asks for the folder of all examples is slow."""
    if "folder" in getattr(item, "fixturenames", ()) and item.path.parent == Path(__file__).parent:
        item.add_marker("slow")


@pytest.fixture(scope="session")
def folder(tmp_path_factory, request):
    place = tmp_path_factory.mktemp("playground")
    # Node.js takes a .js for a module where this says so; a browser needs no such word.
    (place / "package.json").write_text('{"type": "module"}\n')
    with pytest.MonkeyPatch.context() as patch:
        if "not thorough" in request.config.option.markexpr:
            patch.setattr(sketches, "example_folders", lambda: {name: example_folder(name) for name in FEW})
        return make_folder(place / "site").folder


@pytest.fixture(scope="session")
def server(folder):
    serving = Server(folder, compile=compiled, longest=LONGEST)
    yield serving
    serving.close()


# The page on which tests begin run after run, while there are tests of this folder.
OPEN: list[Page] = []


@pytest.hookimpl(trylast=True)
def pytest_runtest_teardown(item, nextitem):
    """The browser ends with the last test that may need it."""
    if OPEN and (nextitem is None or nextitem.path.parent != item.path.parent):
        OPEN.pop().browser.close()


@pytest.fixture
def page(server):
    """One that has loaded, and after each test: no error and no warning in the browser's console."""
    if not OPEN:
        OPEN.append(Page(Browser(), server))
        OPEN[0].open()
    OPEN[0].browser.complaints()
    yield OPEN[0]
    OPEN[0].rest()  # a run takes half a processor
    assert OPEN[0].browser.complaints() == []
