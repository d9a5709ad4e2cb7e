"""Write a compiled sketch into a board over its USB port."""

from __future__ import annotations

import os
import shutil
import subprocess
import termios
import time
from pathlib import Path

from building import BuildFailed, Built, choose_backend

# The boot loader of a Leonardo is a USB device of its own, there for 8 s.
BOOT_LOADER_APPEARS_S = 8.0


def expect_port(port: str) -> None:
    if not Path(port).exists():
        raise BuildFailed(f"no port {port}: plug the board in, and see `ls /dev/ttyACM* /dev/ttyUSB*` for its name")


def upload(built: Built, port: str) -> None:
    """Flash `built` through `port` ("/dev/ttyACM0"). Raises BuildFailed."""
    expect_port(port)
    if choose_backend() == "arduino-cli":
        upload_by_cli(built, port)
    else:
        upload_by_avrdude(built, port)


def upload_by_cli(built: Built, port: str) -> None:
    fqbns = [built.board.fqbn]
    if built.board.name == "nano":
        fqbns.append("arduino:avr:nano:cpu=atmega328old")
    run_first_that_works(
        [["arduino-cli", "upload", "-p", port, "--fqbn", fqbn, "--input-file", str(built.hex)] for fqbn in fqbns], port
    )


def upload_by_avrdude(built: Built, port: str) -> None:
    if not shutil.which("avrdude"):
        raise BuildFailed("avrdude is not installed: run tools/setup build")
    if built.board.programmer == "avr109":
        port = touch_at_1200_baud(port)
    run_first_that_works([avrdude_command(built, port, baud) for baud in built.board.baud_rates], port)


def avrdude_command(built: Built, port: str, baud: int) -> list[str]:
    return [
        "avrdude", "-q", "-p", built.board.mcu, "-c", built.board.programmer, "-P", port, "-b", str(baud),
        "-D", "-U", f"flash:w:{built.hex}:i",
    ]  # fmt: skip


def run_first_that_works(commands: list[list[str]], port: str) -> None:
    said = []
    for command in commands:
        ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
        if ran.returncode == 0:
            return
        said.append(f"{' '.join(command)}\n{(ran.stdout + ran.stderr).strip()}")
    raise BuildFailed(
        f"the board at {port} was not flashed; is it the board named, and no monitor open on it?\n" + "\n".join(said)
    )


def serial_ports() -> set[str]:
    return {str(p) for pattern in ("ttyACM*", "ttyUSB*", "cu.usbmodem*") for p in Path("/dev").glob(pattern)}


def touch_at_1200_baud(port: str) -> str:
    """Ask a board with native USB for its boot loader; returns the port it answers on."""
    handle = os.open(port, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
    try:
        modes = termios.tcgetattr(handle)
        modes[2] |= termios.HUPCL
        modes[4] = modes[5] = termios.B1200
        termios.tcsetattr(handle, termios.TCSANOW, modes)
    finally:
        os.close(handle)
    before = serial_ports() - {port}
    deadline = time.monotonic() + BOOT_LOADER_APPEARS_S
    gone = False
    while time.monotonic() < deadline:
        here = serial_ports()
        if here - before - {port}:
            return (here - before - {port}).pop()
        gone = gone or port not in here
        if gone and port in here:
            return port
        time.sleep(0.1)
    return port
