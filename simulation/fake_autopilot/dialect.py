"""The MAVLink dialect that the fake autopilots speak, for encoding and decoding only.

The module is generated from tools/mavlink/*.xml into build/dialect; it is looked for
there when the test run has not put it on the path already.
"""
import sys
from pathlib import Path

try:
    import mavmission_dialect as mavlink
except ImportError:
    _GENERATED = Path(__file__).resolve().parents[2] / "build" / "dialect"
    if not (_GENERATED / "mavmission_dialect.py").exists():
        raise ImportError(
            f"{_GENERATED}/mavmission_dialect.py is missing: "
            "generate it from tools/mavlink/*.xml with pymavlink first") from None
    sys.path.insert(0, str(_GENERATED))
    import mavmission_dialect as mavlink

__all__ = ["mavlink"]
