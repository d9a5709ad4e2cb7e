"""The site of tools/site: every document, example and header is in it, no link leads nowhere, and a phone shows it."""

from __future__ import annotations

import re
import subprocess
from html import unescape
from pathlib import Path

import pytest

import alone
from building import ROOT
from examples import every_folder, sketch_of
from playing.browser import Browser
from playing.serving import Plain, Server
from siting import dead_links
from siting.pages import example_page, navigation

WIDTHS = {390: 844, 1400: 1000}
# A page of each kind, and those with the widest tables.
LOOKED_AT = [
    "index.html", "docs/measurements.html", "docs/compiling.html", "docs/design/retries.html",
    "examples/PlanConsole.html", "reference/index.html", "reference/annotated.html", "reference/Status_8h.html",
    "reference/classmavmission_1_1MissionClient.html",
]  # fmt: skip
# What the search shows is in a tree of its own.
FOUND = """return [...document.querySelectorAll("*")].map(one => one.shadowRoot).filter(root => root)
  .map(root => root.textContent).join(" ")"""


def named_in(tree) -> list[str]:
    if isinstance(tree, str):
        return [tree]
    return [name for entry in tree for value in entry.values() for name in named_in(value)]


def test_navigation_has_each_document_and_each_example_once():
    names = named_in(navigation())
    documents = [str(file.relative_to(ROOT)) for place in ("*.md", "docs/**/*.md") for file in ROOT.glob(place)]
    sketches = [f"examples/{name}.md" for name in every_folder()]
    assert sorted(names) == sorted([*documents, *sketches, "playground/index.html", "reference/index.html"])


def test_page_of_an_example_has_the_sketch_and_leads_to_the_playground():
    page = example_page("UploadMission")
    assert sketch_of("UploadMission").read_text() in page
    assert "](../playground/index.html#example=UploadMission)" in page


def test_links_that_lead_nowhere_are_found_and_no_others(tmp_path):
    dead = ["gone.html", "two.html#gone", "#gone", "gone.png", "https://elsewhere.example/a.js"]
    (tmp_path / "two.html").write_text('<h1 id="part">')
    (tmp_path / "one.html").write_text(
        '<p id="here"><a href="two.html"><a href="two.html#part"><a href="#here"><a href="https://mavlink.io/">'
        '<a href="gone.html"><a href="two.html#gone"><a href="#gone"><img src="gone.png">'
        '<script src="https://elsewhere.example/a.js"></script>'
    )
    assert sorted(dead_links(tmp_path)) == sorted(f"one.html: {link}" for link in dead)


# The whole of it ------------------------------------------------------------------


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """As the command makes it with its own group of tools/setup alone; a link that leads nowhere would end it."""
    made = tmp_path_factory.mktemp("site") / "site"
    ran = subprocess.run([ROOT / "tools" / "site", "--output", made], capture_output=True, text=True, check=False,
                         stdin=subprocess.DEVNULL, env=alone.environment("site"))  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    return made


@pytest.fixture(scope="module")
def address(site):
    server = Server(site, kind=Plain)
    yield server.address
    server.close()


@pytest.fixture(scope="module")
def browser():
    with Browser() as one:
        yield one


def resize(browser: Browser, width: int) -> None:
    browser.resize(width, WIDTHS[width], phone=width < 500)


@pytest.mark.slow
def test_site_has_the_pages_that_are_looked_at_the_search_and_the_playground(site):
    for name in [*LOOKED_AT, "search.json", "playground/index.html", "playground/examples/UploadMission.hex"]:
        assert (site / name).is_file(), name


def words_of(page: Path) -> str:
    return re.sub(r"\s+", " ", unescape(re.sub(r"<[^>]*>", " ", page.read_text())))


@pytest.mark.slow
def test_reference_is_made_without_a_warning_and_has_what_a_sketch_uses(site):
    """A warning of doxygen's would have ended tools/site."""
    reference = site / "reference"
    client = words_of(reference / "classmavmission_1_1MissionClient.html")
    header = (ROOT / "src" / "mavmission" / "client" / "MissionClient.h").read_text()
    public = re.search(r"^class MissionClient\b.*?public:(.*?)^ private:", header, re.M | re.S)[1]
    functions = set(re.findall(r"^  (?:\w+ )*[\w:]+[&*]? (\w+)\(", public, re.M))
    assert {"upload", "update"} <= functions
    assert [name for name in functions if f" {name} (" not in client and f" {name}(" not in client] == []
    assert "never blocks" in client
    for name in (
        "structMissionItem", "classMissionFollower", "classMessageListener", "classDegrees", "structLinkCounters",
    ):
        page = re.sub("(?=[A-Z])", "mavmission_1_1", name, count=1)
        assert (reference / f"{page}.html").is_file(), page
    # Inner parts are not in it.
    assert not [*reference.glob("*FrameParser*"), *reference.glob("Flash_8h*"), *reference.glob("*mavlink__msg*")]


@pytest.mark.slow
def test_each_page_fits_a_phone_and_a_desk_and_asks_no_other_host(browser, address):
    browser.requests()
    for width in WIDTHS:
        resize(browser, width)
        for name in LOOKED_AT:
            browser.go(address + name)
            browser.wait_for("return document.readyState == 'complete'")
            assert browser.run("return document.documentElement.scrollWidth") <= width, (name, width)
    assert [said for said in browser.complaints() if "favicon.ico" not in said] == []
    asked = [url for url in browser.requests() if re.match(r"(http|ws)s?:", url)]
    assert len(asked) > len(LOOKED_AT)
    assert [url for url in asked if not url.startswith(address)] == []


ON_A_DISK = "file"  # the site's folder, as a browser opens it without a server
# Pyodide tries what else it may do.
TRIED = "Loading the script 'data:text/javascript,' violates"


@pytest.mark.slow
@pytest.mark.parametrize("scheme", ["http", ON_A_DISK])
def test_playground_of_the_site_flies(browser, site, address, scheme):
    resize(browser, 1400)
    browser.complaints()
    browser.go(f"{f'{site.as_uri()}/' if scheme == ON_A_DISK else address}playground/index.html")
    browser.wait_for("return document.querySelector('#outcome').innerText.includes('are aboard ArduPilot as they')")
    assert [said for said in browser.complaints() if TRIED not in said] == []


@pytest.mark.slow
@pytest.mark.parametrize(("width", "scheme"), [*((width, "http") for width in WIDTHS), (1400, ON_A_DISK)])
def test_search_finds_a_page_by_its_words(browser, site, address, width, scheme):
    resize(browser, width)
    browser.go(f"{f'{site.as_uri()}/' if scheme == ON_A_DISK else address}index.html")
    browser.wait_for("return document.readyState == 'complete' && document.querySelector('.md-search__button')")
    browser.run("document.querySelector('.md-search__button').click()")
    browser.wait_for(f"{FOUND} != ''")
    for letter in "passphrase":
        browser.press(letter)
    assert browser.wait_for(FOUND.replace("return", "return (") + ").includes('A signed link')")
