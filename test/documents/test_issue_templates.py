"""The forms for issues ask for what is needed, LinkDoctor's output first, and name what there is."""

from __future__ import annotations

import re

import pytest
import yaml

from building import ROOT
from examples import sketch_of

FOLDER = ROOT / ".github" / "ISSUE_TEMPLATE"
FORMS = sorted(FOLDER.glob("[!c]*.yml"))
# GitHub's kinds of a form's elements that are used here.
KINDS = {"textarea", "input", "checkboxes"}


def form(name: str) -> dict:
    return yaml.safe_load((FOLDER / name).read_text())


def test_there_is_a_form_for_what_does_not_work_and_for_what_is_missing():
    assert [file.name for file in FORMS] == ["defect.yml", "wish.yml"]
    assert form("config.yml") == {"blank_issues_enabled": False}


@pytest.mark.parametrize("file", FORMS, ids=lambda file: file.name)
def test_form_is_one_that_github_takes(file):
    read = form(file.name)
    assert read.keys() == {"name", "description", "labels", "body"}
    ids = [element["id"] for element in read["body"]]
    assert len(ids) == len(set(ids)) and all(re.fullmatch(r"[\w-]+", one) for one in ids)
    for element in read["body"]:
        assert element.keys() <= {"type", "id", "attributes", "validations"}
        assert element["type"] in KINDS and element["attributes"]["label"]
    assert any(element.get("validations") == {"required": True} for element in read["body"])


def test_output_of_linkdoctor_is_asked_for_first_and_as_its_sketch_gives_it():
    first = form("defect.yml")["body"][0]
    assert first["id"] == "linkdoctor" and first["validations"] == {"required": True}
    sketch = sketch_of("LinkDoctor").read_text()
    (baud,) = re.findall(r"(\d+) baud", first["attributes"]["description"])
    assert f"CONSOLE.begin({baud})" in sketch


def test_files_and_names_in_the_forms_are_there():
    said = "".join(file.read_text() for file in FORMS)
    documents = re.findall(r"[\w/]+\.md", said)
    assert {"docs/troubleshooting.md", "SECURITY.md"} <= set(documents)
    assert [name for name in documents if not (ROOT / name).exists()] == []
    client = (ROOT / "src" / "mavmission" / "client" / "MissionClient.h").read_text()
    assert [name for name in re.findall(r"(\w+)\(\)", said) if f"{name}(" not in client + "toString("] == []
    assert "MAVMISSION_VERSION" in (ROOT / "src" / "MavMission.h").read_text()
