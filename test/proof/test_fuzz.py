"""Fuzzing: a fixed number of inputs, the same each time.

What must hold is written at the top of fuzz/parser.cpp, fuzz/client.cpp and fuzz/files.cpp. A longer search, by hand:

    build/venv/bin/python test/proof/test_fuzz.py client -max_total_time=3600

takes any of libFuzzer's options and keeps what it finds under build/fuzz. An input that breaks something is
named there; put it into fuzz/corpus/<target>/ under a name that says what it shows.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

if __name__ == "__main__":
    sys.path[:0] = [str(Path(__file__).resolve().parents[2]), str(Path(__file__).resolve().parents[1] / "support")]

import pytest

from simulation.firmware import LIBRARY, ROOT, library_file
from simulation.host_build import FUZZED, HOST, build_host
from simulation.together import together

FUZZ = ROOT / "test" / "fuzz"
# What a client and PlanFiles use of the library.
CLIENT = [source for folder in ("autopilot", "base", "client", "files", "item", "link", "plan", "service", "signing",
                                "transfer")
          for source in sorted((LIBRARY / "mavmission" / folder).glob("*.cpp"))]  # fmt: skip
PARSER = [library_file(name) for name in ("Checksum.cpp", "FrameParser.cpp", "Messages.cpp")]

# target: (its other sources, the library's, inputs that are tried, the longest one [bytes])
TARGETS = {"parser": ((), PARSER, 60_000, 600), "client": (("Evidence.cpp",), CLIENT, 15_000, 400),
           "files": (("Evidence.cpp",), CLIENT, 15_000, 300)}  # fmt: skip


def build_target(target: str) -> Path:
    others, library, *_ = TARGETS[target]
    sources = [FUZZ / f"{target}.cpp", *(FUZZ / name for name in others), HOST / "Frames.cpp", HOST / "PlanFrames.cpp"]
    parts = together(library)
    return build_host(f"fuzz-{target}", sources, "clang++", FUZZED, library=parts, link=["-fsanitize=fuzzer"])


# What would make a run differ from the one before: words of compared values are put into inputs, and pointers are
# among them; new inputs are read again from the disk after a second; a folder lists its files in any order. (The depth
# of the stack, which depends on the environment, is left out of FUZZED.)
ALWAYS_THE_SAME = ["-use_cmp=0", "-reload=0"]


def fuzz(target: str, found: Path, *options: str) -> subprocess.CompletedProcess:
    """Runs a target from its corpus; new inputs and those that break something go to `found`. Always the same run."""
    found.mkdir(parents=True, exist_ok=True)
    corpus = found.with_name(f"{found.name}-corpus")
    corpus.write_text(",".join(str(path) for path in sorted((FUZZ / "corpus" / target).iterdir())))
    # libFuzzer's limit of memory looks at the peak that the system reports, and Linux counts the peak of the process
    # that started this one: a test worker that has grown would fail it. The library takes no memory that could grow.
    limits = ["-rss_limit_mb=0", "-malloc_limit_mb=64"]
    places = [f"-artifact_prefix={found}/", f"-seed_inputs=@{corpus}", found]
    words = [build_target(target), *limits, *ALWAYS_THE_SAME, *options, *places]
    return subprocess.run(words, capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "target", ["parser", *(pytest.param(target, marks=pytest.mark.slow) for target in ("client", "files"))]
)
def test_what_must_hold_holds_for_the_corpus(target):
    corpus = sorted((FUZZ / "corpus" / target).iterdir())
    words = [build_target(target), "-rss_limit_mb=0", *corpus]
    ran = subprocess.run(words, capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr[-6000:]
    assert ran.stderr.count("Executed ") == len(corpus) > 5


@pytest.mark.slow
@pytest.mark.parametrize("target", TARGETS)
def test_what_must_hold_holds_for_inputs_grown_from_it(target, tmp_path):
    *_, runs, longest = TARGETS[target]
    ran = fuzz(target, tmp_path / "found", f"-runs={runs}", "-seed=1", f"-max_len={longest}")
    assert ran.returncode == 0, ran.stderr[-6000:]
    assert f"Done {runs} runs" in ran.stderr


if __name__ == "__main__":
    if len(sys.argv) < 2 or sys.argv[1] not in TARGETS:
        sys.exit(f"usage: test_fuzz.py {'|'.join(TARGETS)} [libFuzzer's options]\n\n{__doc__}")
    keep = ROOT / "build" / "fuzz" / sys.argv[1]
    keep.mkdir(parents=True, exist_ok=True)
    program = build_target(sys.argv[1])
    os.execv(
        program,
        [str(program), *sys.argv[2:], f"-artifact_prefix={keep}/", str(keep), str(FUZZ / "corpus" / sys.argv[1])],
    )
