"""Debian's chromium without a screen, told what to do through its driver (WebDriver, as chromedriver speaks it).

with Browser() as browser:
    browser.go("http://127.0.0.1:8000/")
    browser.wait_for("return document.title")
"""

from __future__ import annotations

import base64
import json
import os
import shutil
import socket
import subprocess
import tempfile
import time
import urllib.error
import urllib.request
from pathlib import Path
from typing import Any

STARTS_S = 120.0
LOOKS_EVERY_S = 0.1
ASKED_EVERY_S = 2.0
WAIT = """return new Promise((done, failed) => {
  const begun = performance.now();
  const look = () => {
    try {
      const found = (() => { %s
      })();
      if (found || performance.now() - begun > %g) done(found);
      else setTimeout(look, %g);
    } catch (error) { failed(error); }
  };
  look();
})"""
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"  # as the WebDriver standard calls a reference to one
NOT_FOR_TESTS = (
    "--disable-background-networking", "--disable-component-update", "--disable-default-apps", "--disable-sync",
    "--disable-features=Translate,OptimizationHints,MediaRouter", "--no-first-run", "--no-default-browser-check",
    "--disable-dev-shm-usage", "--hide-scrollbars",
)  # fmt: skip


class NoBrowser(Exception):
    """chromium or its driver does not start, or does not do what it is told; the text says why."""


class Browser:
    """A window of its own profile. What a page is waited for is looked at again and again, up to a limit."""

    def __init__(self, width: int = 1400, height: int = 1000, *, dark: bool = False) -> None:
        driver = shutil.which("chromedriver")
        if driver is None or shutil.which("chromium") is None:
            raise NoBrowser("chromium or chromium-driver is missing: run tools/setup browser")
        self._profile = tempfile.TemporaryDirectory(prefix="playground-")
        port = free_port()
        self._driver = subprocess.Popen(
            [driver, f"--port={port}"], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
            env={**os.environ, "TMPDIR": self._profile.name},
        )  # fmt: skip
        self._base = f"http://127.0.0.1:{port}"
        arguments = [
            "--headless=new", f"--window-size={width},{height}", f"--user-data-dir={self._profile.name}/profile",
            *NOT_FOR_TESTS,
        ]  # fmt: skip
        if os.geteuid() == 0:
            arguments.append("--no-sandbox")  # chromium has no sandbox for root
        wanted = {
            "browserName": "chrome",
            "goog:chromeOptions": {"binary": shutil.which("chromium"), "args": arguments},
            "goog:loggingPrefs": {"browser": "ALL", "performance": "ALL"},
        }
        try:
            self._wait_until_it_answers()
            self._session = self._ask("POST", "/session", {"capabilities": {"alwaysMatch": wanted}})["sessionId"]
            self.resize(width, height)
            features = [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]
            self.devtools("Emulation.setEmulatedMedia", {"features": features})
        except BaseException:
            self.close()
            raise

    def __enter__(self) -> Browser:
        return self

    def __exit__(self, *_) -> None:
        self.close()

    def close(self) -> None:
        if getattr(self, "_session", None):
            try:
                self._ask("DELETE", f"/session/{self._session}")
            except NoBrowser:
                pass
            self._session = ""
        self._driver.terminate()
        self._driver.wait()
        self._profile.cleanup()

    def go(self, address: str) -> None:
        self._order("POST", "url", {"url": address})

    def run(self, script: str, *arguments: Any) -> Any:
        """What a JavaScript function of this body returns."""
        return self._order("POST", "execute/sync", {"script": script, "args": list(arguments)})

    def wait_for(self, script: str, limit_s: float = STARTS_S) -> Any:
        """What it returns, as soon as that is true. The page itself looks: being asked takes ten times as long."""
        limit = time.monotonic() + limit_s
        while not (found := self.run(WAIT % (script, ASKED_EVERY_S * 1000, LOOKS_EVERY_S * 1000))):
            if time.monotonic() > limit:
                raise NoBrowser(f"not within {limit_s:g} s: {script}\n{self.text('body')}")
        return found

    def text(self, selector: str) -> str:
        return self.run("return document.querySelector(arguments[0]).innerText", selector)

    def click(self, selector: str) -> None:
        self._order("POST", f"element/{self._element(selector)}/click", {})

    def type(self, selector: str, text: str) -> None:
        """Press these keys in an element; for a file's input, the path of the file."""
        self._order("POST", f"element/{self._element(selector)}/value", {"text": text})

    def press(self, key: str) -> None:
        """One key, wherever the focus is; WebDriver has code points for those without a letter."""
        actions = [{"type": kind, "value": key} for kind in ("keyDown", "keyUp")]
        self._order("POST", "actions", {"actions": [{"type": "key", "id": "keys", "actions": actions}]})

    def resize(self, width: int, height: int, phone: bool = False) -> None:
        """What the page has for itself."""
        size = {"width": width, "height": height, "deviceScaleFactor": 2 if phone else 1, "mobile": phone}
        self.devtools("Emulation.setDeviceMetricsOverride", size)

    def devtools(self, command: str, parameters: dict) -> Any:
        return self._order("POST", "goog/cdp/execute", {"cmd": command, "params": parameters})

    def before_each_page(self, script: str) -> None:
        """To be run in each page before its own scripts."""
        self.devtools("Page.addScriptToEvaluateOnNewDocument", {"source": script})

    def screenshot(self, file: Path, whole: bool = False) -> None:
        if whole:
            said = self.devtools("Page.captureScreenshot", {"captureBeyondViewport": True})["data"]
        else:
            said = self._order("GET", "screenshot")
        file.write_bytes(base64.b64decode(said))

    def complaints(self) -> list[str]:
        """What stands in the browser's console since the last call, warnings and errors."""
        log = self._order("POST", "se/log", {"type": "browser"})
        return [entry["message"] for entry in log if entry["level"] in ("WARNING", "SEVERE")]

    def requests(self) -> list[str]:
        """The addresses that were asked for since the last call, by the page and its workers."""
        log = self._order("POST", "se/log", {"type": "performance"})
        messages = [json.loads(entry["message"])["message"] for entry in log]
        return [message["params"]["request"]["url"] for message in messages
                if message["method"] == "Network.requestWillBeSent"]  # fmt: skip

    def _element(self, selector: str) -> str:
        return self._order("POST", "element", {"using": "css selector", "value": selector})[ELEMENT]

    def _order(self, method: str, what: str, body: dict | None = None) -> Any:
        return self._ask(method, f"/session/{self._session}/{what}", body)

    def _ask(self, method: str, path: str, body: dict | None = None) -> Any:
        data = None if body is None else json.dumps(body).encode()
        request = urllib.request.Request(self._base + path, data, {"Content-Type": "application/json"}, method=method)
        try:
            with urllib.request.urlopen(request, timeout=120) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            said = json.load(error)["value"]
            raise NoBrowser(f"{path}: {said['error']}: {said['message'].splitlines()[0]}") from error
        except OSError as error:
            raise NoBrowser(f"{path}: {error}") from error

    def _wait_until_it_answers(self) -> None:
        limit = time.monotonic() + STARTS_S
        while True:
            try:
                if self._ask("GET", "/status")["ready"]:
                    return
            except NoBrowser:
                if self._driver.poll() is not None or time.monotonic() > limit:
                    raise NoBrowser("chromedriver does not start") from None
            time.sleep(LOOKS_EVERY_S)


def free_port() -> int:
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]
