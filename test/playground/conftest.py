"""The playground's folder, made once for each worker of the tests."""

from __future__ import annotations

import pytest

from played import Page
from playing import make_folder
from playing.browser import Browser
from playing.compiling import LONGEST, compiled
from playing.serving import Server


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("playground")
    # Node.js takes a .js for a module where this says so; a browser needs no such word.
    (place / "package.json").write_text('{"type": "module"}\n')
    return make_folder(place / "site").folder


@pytest.fixture(scope="session")
def server(folder):
    serving = Server(folder, compile=compiled, longest=LONGEST)
    yield serving
    serving.close()


@pytest.fixture(scope="session")
def opened(server):
    """A page that has loaded; tests begin run after run on it."""
    with Browser() as browser:
        page = Page(browser, server)
        page.open()
        yield page


@pytest.fixture
def page(opened):
    """It, and after each test: no error and no warning in the browser's console."""
    opened.browser.complaints()
    opened.pause(False)
    yield opened
    assert opened.browser.complaints() == []
    opened.pause(True)
