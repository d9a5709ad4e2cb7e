"""What a browser needs beside the site to show it from a disk (file:), where it fetches nothing and starts no worker:
the index of the search and the playground's files once more, as plain scripts. A server is never asked for them."""

from __future__ import annotations

import base64
import gzip
import json
from pathlib import Path

HERE = Path(__file__).resolve().parent
LOADED = (".hex", ".ino", ".js", ".json", ".mjs", ".wasm", ".zip")
# Of the playground's page. A worker from a disk has the page's policy, which beside a server it does not have.
CHANGED = {
    '<link rel="modulepreload" href="main.js">\n': "",
    '<script type="module" src="main.js"></script>': '<script src="disk.js"></script>',
    "script-src 'self' blob:": "script-src 'self' blob: 'wasm-unsafe-eval'",
}
# From a disk the pages' script asks for search.js, which is to define __index, and then starts the search's worker.
SEARCH = """var __index = {index};
{{
  const Plain = Worker, address = URL.createObjectURL(new Blob([{worker}], {{ type: "text/javascript" }}));
  Worker = class extends Plain {{ constructor(_, options) {{ super(address, options); }} }};
}}
"""


def add_playground(folder: Path) -> None:
    """To the playground's folder: disk.js, which begins its page, and packed.js."""
    packed = {
        file.relative_to(folder).as_posix(): base64.b64encode(gzip.compress(file.read_bytes(), mtime=0)).decode()
        for file in sorted(folder.rglob("*"))
        if file.suffix in LOADED
    }
    (folder / "packed.js").write_text(f"const PACKED = {json.dumps(packed, indent=0)};\n")
    (folder / "disk.js").write_text((HERE / "disk.js").read_text())
    page = (folder / "index.html").read_text()
    for old, new in CHANGED.items():
        if page.count(old) != 1:
            raise ValueError(f"the playground's page has not once: {old}")
        page = page.replace(old, new)
    (folder / "index.html").write_text(page)


def add_search(folder: Path) -> None:
    """To the site's folder: search.js, of search.json and the search's worker."""
    (worker,) = folder.glob("assets/javascripts/workers/search.*.js")
    text = SEARCH.format(index=(folder / "search.json").read_text(), worker=json.dumps(worker.read_text()))
    (folder / "search.js").write_text(text)
