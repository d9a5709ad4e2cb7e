"""The fake autopilot as a process of its own: in real time, behind a TCP port, as a SITL is.

    build/venv/bin/python test/support/autopilot_process.py PX4 --port 5762

Serves one client after the other, until it is killed. Says "listening on PORT", and "aboard: N items" each time that it
has accepted a plan.
"""

from __future__ import annotations

import argparse
import select
import socket
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Px4, mavlink

PERSONALITIES = {"ArduPilot": ArduPilot, "PX4": Px4}
LONGEST_WAIT_S = 1.0


def serve(client: socket.socket, autopilot: FakeAutopilot, began: float) -> None:
    """Until the client goes."""
    plans = 0
    while True:
        now = time.monotonic() - began
        due = autopilot.next_event(now)
        wait_s = LONGEST_WAIT_S if due is None else min(LONGEST_WAIT_S, max(0.0, due - now))
        if select.select([client], [], [], wait_s)[0]:
            data = client.recv(4096)
            if not data:
                return
            autopilot.receive(data, time.monotonic() - began)
        client.sendall(autopilot.run(time.monotonic() - began))
        accepted = sum(ack.type == mavlink.MAV_MISSION_ACCEPTED for ack in autopilot.messages("<", "MISSION_ACK"))
        if accepted > plans:
            plans = accepted
            print(f"aboard: {len(autopilot.received())} items", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("personality", choices=PERSONALITIES)
    parser.add_argument("--port", type=int, default=0, help="TCP port on this computer (default: one that is free)")
    args = parser.parse_args()
    autopilot = PERSONALITIES[args.personality](uptime_s=60.0)
    began = time.monotonic()
    with socket.create_server(("127.0.0.1", args.port)) as listener:
        print(f"listening on {listener.getsockname()[1]}", flush=True)
        while True:
            client, _ = listener.accept()
            with client:
                try:
                    serve(client, autopilot, began)
                except ConnectionError:
                    pass


if __name__ == "__main__":
    main()
