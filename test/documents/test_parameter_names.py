"""Parameters that ArduPilot 4.7 has under another name: a page that names the old one names the new one, too."""

from __future__ import annotations

import re

import pytest

from simulation.firmware import ROOT

PAGES = sorted([ROOT / "README.md", *(ROOT / "docs").rglob("*.md")])
RENAMED = {
    "SRn_": (r"\bSR[n0-9]_", r"\bMAV[n0-9]_"),
    "SYSID_MYGCS": (r"\bSYSID_MYGCS\b", r"\bMAV_GCS_SYSID\b"),
    "SYSID_THISMAV": (r"\bSYSID_THISMAV\b", r"\bMAV_SYSID\b"),
    "SYSID_ENFORCE": (r"\bSYSID_ENFORCE\b", r"\bMAV_OPTIONS\b"),
    "ARMING_CHECK": (r"\bARMING_CHECK\b", r"\bARMING_SKIPCHK\b"),
}  # fmt: skip


@pytest.mark.parametrize("parameter", RENAMED)
@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_page_that_names_a_parameter_has_its_newer_name(page, parameter):
    old, new = RENAMED[parameter]
    text = page.read_text()
    assert not re.search(old, text) or re.search(new, text)


@pytest.mark.parametrize("parameter", RENAMED)
def test_some_page_names_it(parameter):
    assert any(re.search(RENAMED[parameter][0], page.read_text()) for page in PAGES)
