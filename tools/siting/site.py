"""The folder of static files, put together: Zensical makes the pages, and copies reference and playground beside them.

A link of a document that leads nowhere ends it: Zensical runs with --strict, and dead_links() looks at what it made.
"""

from __future__ import annotations

import fcntl
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

from building import BUILD
from playing import NotMade as NoPlayground
from playing import make_folder

from .disk import add_playground, add_search
from .links import dead_links
from .pages import PLAYGROUND, REFERENCE, copy_documents, navigation, write_examples
from .reference import NoReference, write_reference

SITE = BUILD / "site" / "site"
SETTINGS = Path(__file__).resolve().parent / "zensical.yml"


class NotMade(Exception):
    """The site could not be made; the text says why."""


def make_site(folder: Path = SITE) -> Path:
    """Make it anew, in a folder that is replaced. Raises NotMade."""
    place = folder.parent
    place.mkdir(parents=True, exist_ok=True)
    with (place / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        pages = place / "pages"
        for old in (pages, folder):
            shutil.rmtree(old, ignore_errors=True)
        try:
            fill(pages)
        except (NoPlayground, NoReference, OSError) as error:
            raise NotMade(str(error)) from error
        settings = place / "zensical.yml"
        settings.write_text(
            SETTINGS.read_text().replace("site_dir: site", f"site_dir: {folder.name}")
            + f"\nnav: {json.dumps(navigation())}\n"
        )
        run_zensical(settings)
        add_search(folder)
        dead = dead_links(folder)
        if dead:
            raise NotMade("these links lead nowhere:\n" + "\n".join(dead))
    return folder


def fill(pages: Path) -> None:
    copy_documents(pages)
    shutil.copy(SETTINGS.with_name("pages.css"), pages)
    write_examples(pages)
    write_reference(pages / Path(REFERENCE).parent)
    shutil.copytree(make_folder().folder, pages / Path(PLAYGROUND).parent)
    add_playground(pages / Path(PLAYGROUND).parent)


def run_zensical(settings: Path) -> None:
    command = [sys.executable, "-m", "zensical", "build", "--clean", "--strict", "--config-file", settings.name]
    ran = subprocess.run(
        command, cwd=settings.parent, capture_output=True, text=True, check=False, env={**os.environ, "NO_COLOR": "1"}
    )
    if ran.returncode != 0:
        said = (ran.stdout + ran.stderr).partition("Traceback")[0].strip()
        raise NotMade(f"Zensical finds something amiss:\n{said}")
