"""The MAVLink headers in the repository are the generated ones, and safe with a small buffer."""

import hashlib
import re
import shutil
import subprocess
from pathlib import Path

import pytest

from mavlink_headers import DEFINITIONS, ROOT, VENDORED

TOOL = ROOT / "tools" / "vendor_mavlink"


def check(headers: Path) -> subprocess.CompletedProcess:
    return subprocess.run([TOOL, "--check", "--headers", headers], capture_output=True, text=True, check=False)


@pytest.fixture
def copied(tmp_path: Path) -> Path:
    return Path(shutil.copytree(VENDORED, tmp_path / "mavlink"))


def test_headers_are_what_the_definitions_generate():
    ran = check(VENDORED)
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_check_names_an_edited_a_missing_and_an_extra_header(copied):
    (copied / "checksum.h").write_bytes((copied / "checksum.h").read_bytes() + b"\n")
    (copied / "protocol.h").unlink()
    (copied / "common" / "mine.h").write_text("\n")
    ran = check(copied)
    assert ran.returncode == 1
    assert ran.stdout.splitlines() == [
        "protocol.h: missing",
        "common/mine.h: not generated, remove it",
        "checksum.h: differs from what is generated",
    ]


def test_provenance_names_the_definitions_by_their_checksums():
    page = (DEFINITIONS / "PROVENANCE.md").read_text()
    named = dict(re.findall(r"^\| `(\w+\.xml)` \| `([0-9a-f]{64})` \|$", page, re.M))
    assert named == {f.name: hashlib.sha256(f.read_bytes()).hexdigest() for f in DEFINITIONS.glob("*.xml")}


def test_provenance_names_the_generator_that_is_pinned():
    pinned = re.search(r"^pymavlink==(\S+)$", (ROOT / "tools" / "requirements" / "demo.txt").read_text(), re.M)[1]
    assert f"pymavlink {pinned}," in (VENDORED / "PROVENANCE.md").read_text()


def test_both_licences_travel_with_the_files_they_cover():
    exception = "product is hereby licensed under the following MIT license"
    assert exception in (DEFINITIONS / "COPYING").read_text()
    assert "GNU LESSER GENERAL PUBLIC LICENSE" in (DEFINITIONS / "COPYING").read_text()
    assert "Permission is hereby granted, free of charge" in (VENDORED / "LICENSE").read_text()


def run_payload_bounds(headers: Path, folder: Path) -> subprocess.CompletedProcess:
    """test/payload_bounds.cpp with a 38-byte payload, the longest that a mission needs."""
    program = folder / "payload_bounds"
    command = ["g++", "-std=c++11", "-O1", "-g", "-fsanitize=address", "-fno-sanitize-recover", "-w"]
    command += ["-DMAVLINK_MAX_PAYLOAD_LEN=38", f"-I{headers}", ROOT / "test" / "payload_bounds.cpp", "-o", program]
    subprocess.run(command, check=True)
    return subprocess.run([program], capture_output=True, text=True, check=False)


def test_no_message_writes_past_a_payload_buffer_made_smaller(tmp_path):
    ran = run_payload_bounds(VENDORED, tmp_path)
    assert ran.returncode == 0, ran.stdout + ran.stderr


@pytest.mark.slow
def test_the_bounds_check_catches_headers_without_the_correction(copied, tmp_path):
    parser = copied / "mavlink_helpers.h"
    text = parser.read_text()
    corrected = "e->max_msg_len < MAVLINK_MAX_PAYLOAD_LEN ? e->max_msg_len : MAVLINK_MAX_PAYLOAD_LEN"
    assert text.count(corrected) == 1
    parser.write_text(text.replace(corrected, "e->max_msg_len"))
    ran = run_payload_bounds(copied, tmp_path)
    assert ran.returncode != 0
    assert "heap-buffer-overflow" in ran.stderr
