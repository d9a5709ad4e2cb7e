"""The licences of what the folder packs, beside it."""

from __future__ import annotations

import shutil
from pathlib import Path

from building import ROOT

DOCS = Path("/usr/share/doc")
COMMON = Path("/usr/share/common-licenses")


def texts(npm: Path) -> dict[str, Path]:
    """The licence texts, by their names in the folder."""
    return {
        "MavMission.txt": ROOT / "LICENSE",
        "MAVLink.txt": ROOT / "tools" / "mavlink" / "COPYING",
        "avr8js.txt": npm / "avr8js" / "LICENSE",
        "Pyodide-MPL-2.0.txt": COMMON / "MPL-2.0",
        "Python.txt": DOCS / "libpython3.11-minimal" / "copyright",
        "Arduino-core.txt": DOCS / "arduino-core-avr" / "copyright",
        "LGPL-2.1.txt": COMMON / "LGPL-2.1",
        "avr-libc.txt": DOCS / "avr-libc" / "copyright",
        "gcc-runtime.txt": DOCS / "gcc-avr" / "copyright",
        "wasi-libc.txt": DOCS / "wasi-libc" / "copyright",
    }


SAID = """What this folder packs, and under which licence

MavMission, the examples and this page           MIT                      MavMission.txt
the MAVLink messages in Python and in C          MIT, as generated code   MAVLink.txt
avr8js {avr8js}, https://github.com/wokwi/avr8js
                                                 MIT                      avr8js.txt
Pyodide {pyodide}, https://github.com/pyodide/pyodide
                                                 MPL 2.0                  Pyodide-MPL-2.0.txt
Python and its standard library, in Pyodide      PSF licence              Python.txt
the Arduino core, in the compiled examples       LGPL 2.1 or later        Arduino-core.txt, LGPL-2.1.txt
avr-libc, in the compiled examples               BSD                      avr-libc.txt
libgcc, in the compiled examples                 GPL 3 with the runtime exception  gcc-runtime.txt
wasi-libc, in hearing.wasm                       MIT and others           wasi-libc.txt

The files of avr8js and of Pyodide are as npm has them, but for ".js" behind the names in avr8js's imports. The source
of the examples, and how they are compiled, is in MavMission's repository: whoever wants another Arduino core in them
runs tools/playground there.
"""


def copy_licences(folder: Path, npm: Path, versions: dict[str, str]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    for name, source in texts(npm).items():
        shutil.copyfile(source, folder / name)
    (folder / "README.txt").write_text(SAID.format(**versions))
