"""The folder at the loopback address."""

from __future__ import annotations

import functools
import http.server
import json
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

# What the page asks of a server where it has a say: that nothing from another host is loaded, by its workers neither.
# Any other server will do as well, but for a build of ArduPilot that the visitor brings (blob:): its threads share
# memory, which browsers allow to a page with the two Cross-Origin headers alone.
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; script-src 'self' blob: 'wasm-unsafe-eval'; style-src 'self'; "
    "img-src 'self' data:; connect-src 'self'; worker-src 'self' blob:; base-uri 'none'; form-action 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Embedder-Policy": "require-corp",
    "Cache-Control": "no-cache",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
}


class Handler(http.server.SimpleHTTPRequestHandler):
    extensions_map = {  # noqa: RUF012  # as the base class has it
        **http.server.SimpleHTTPRequestHandler.extensions_map,
        ".js": "text/javascript",
        ".mjs": "text/javascript",
        ".wasm": "application/wasm",
        ".hex": "text/plain",
    }
    protocol_version = "HTTP/1.1"
    headers_too = HEADERS

    def end_headers(self) -> None:
        for name, value in self.headers_too.items():
            self.send_header(name, value)
        if self.server.compile:  # type: ignore[attr-defined]  # by which the page knows that there is one
            self.send_header("Playground-Compiler", "here")
        super().end_headers()

    def do_POST(self) -> None:
        """A sketch to be compiled, of the page that this server has served, and of no other."""
        server: Any = self.server
        length = int(self.headers.get("Content-Length") or 0)
        own = server.address.rstrip("/")
        if self.path != "/compile" or not server.compile or self.headers.get("Origin") != own:
            return self.send_error(403)
        if length > server.longest:
            return self.send_error(413)
        said = json.dumps(server.compile(self.rfile.read(length).decode("utf-8", "replace"))).encode()
        self.send_response(200)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(said)))
        self.end_headers()
        self.wfile.write(said)

    def log_message(self, *_) -> None:
        pass


class Plain(Handler):
    """For pages with scripts of their own in them, as documents have."""

    headers_too = {"Cache-Control": "no-cache"}  # noqa: RUF012  # as the base class has it


class Server(http.server.ThreadingHTTPServer):
    """Serves a folder from its start to close(), in a thread; port 0: any that is free. compile: what makes firmware of
    a sketch of up to `longest` bytes that the page sends; None: nothing does."""

    daemon_threads = True

    def __init__(
        self, folder: Path, port: int = 0, kind: type[Handler] = Handler,
        compile: Callable[[str], dict] | None = None, longest: int = 0,
    ) -> None:  # fmt: skip
        self.compile, self.longest = compile, longest
        handler: Callable = functools.partial(kind, directory=str(folder))
        super().__init__(("127.0.0.1", port), handler)
        self._thread = threading.Thread(target=self.serve_forever, daemon=True)
        self._thread.start()

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_address[1]}/"

    def wait(self) -> None:
        """Until it is interrupted."""
        self._thread.join()

    def close(self) -> None:
        self.shutdown()
        self.server_close()
