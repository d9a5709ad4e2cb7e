"""The bench for the whole mission service (service.py) on an emulated Cortex-M0 instead of a simulated Mega."""

from __future__ import annotations

from collections.abc import Sequence

from simulation.bench import _ITEM, PLAN_ITEMS, packed
from simulation.fake_autopilot import Item
from simulation.microbit import Microbit, build_cortex_m0
from simulation.service import SOURCE, Service, unpacked

FILLED = 36  # bytes of a MissionItem where it is aligned


class CortexM0Service(Service):
    """defines: also UART_RX, UART_TX and UART_ROOM, by which the ports behave as another board's do."""

    def __init__(self, personality: str | None, **options) -> None:
        self.personality = personality
        super().__init__(personality, **options)

    def _board(self, baud: int, defines: dict) -> Microbit:
        elf = build_cortex_m0("service", [SOURCE], {"BENCH_BAUD": baud, "BENCH_DIRECT": True, **defines})
        return Microbit(elf, (500000, baud))

    def __enter__(self) -> CortexM0Service:
        return self

    def __exit__(self, *_) -> None:
        self.mega.close()

    def write_plan(self, plan: Sequence[Item]) -> None:
        assert len(plan) <= PLAN_ITEMS
        self.mega.poke("benchPlan", b"".join(packed(item).ljust(FILLED, b"\0") for item in plan))

    def sink(self, count: int) -> list[Item]:
        data = self.mega.peek("benchSink", count * FILLED)
        return [unpacked(data[at : at + _ITEM.size]) for at in range(0, len(data), FILLED)]

    def blocked(self) -> int:
        """Bytes that write() of the core had to wait with."""
        return self.mega.peek_int("waitedBytes", 4)

    def lost(self) -> int:
        """Bytes that came when the core's ring was full."""
        return self.mega.peek_int("lostBytes", 4)
