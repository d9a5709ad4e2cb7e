"""The playground's folder, made once for each worker of the tests."""

from __future__ import annotations

import pytest

from playing import make_folder
from playing.serving import Server


@pytest.fixture(scope="session")
def folder(tmp_path_factory):
    place = tmp_path_factory.mktemp("playground")
    # Node.js takes a .js for a module where this says so; a browser needs no such word.
    (place / "package.json").write_text('{"type": "module"}\n')
    return make_folder(place / "site").folder


@pytest.fixture(scope="session")
def server(folder):
    serving = Server(folder)
    yield serving
    serving.close()
