"""Build the baseline firmware, against which this library's sizes and speeds are set.

    from baseline import build_baseline
    built = build_baseline(wire=1)      # or 2

It marks two functions to watch: baseline_parse (called once per byte) and
baseline_pack (called once per item).
"""

from __future__ import annotations

from building import BUILD, ROOT, Built, build_sketch, exclusive
from mavlink_headers import VENDORED, generate

SOURCE = ROOT / "test" / "baseline" / "baseline.cpp"


def build_baseline(wire: int = 2) -> Built:
    """The baseline for MAVLink `wire` (1 or 2), on a Mega. Raises BuildFailed."""
    if wire == 2:
        return build_sketch(SOURCE, include_dirs=[VENDORED / "common"])
    headers = BUILD / "mavlink1"
    with exclusive(BUILD / "mavlink1.lock"):
        if not (headers / "common" / "mavlink.h").is_file():
            generate(headers, wire_protocol="1.0")
    return build_sketch(SOURCE, defines=["BASELINE_MAVLINK1"], include_dirs=[headers / "common"])
