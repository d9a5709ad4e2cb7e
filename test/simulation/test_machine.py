"""The simulated Mega itself: what the other tests trust it to do."""

from __future__ import annotations

import struct
import subprocess
from itertools import pairwise
from pathlib import Path

import pytest

from simulation.firmware import FirmwareNotBuilt, build_firmware
from simulation.mega import BadImage, Crashed, Mega, NoSuchSymbol
from simulation.mega.check import compare_instructions

SOURCES = Path(__file__).resolve().parents[1] / "machine"
MS = 16_000  # cycles


def machine(name: str, mcu: str = "atmega2560", **defines: object) -> Mega:
    return Mega(build_firmware(name, [SOURCES / f"{name}.cpp"], defines, mcu, library=False))


@pytest.mark.parametrize(("baud", "byte_cycles"), [(57600, 2720), (115200, 1360)])
def test_four_thousand_bytes_each_way_take_four_thousand_byte_times_and_none_is_lost(baud, byte_cycles):
    mega = machine("stream", BAUD=baud, COUNT=4000)
    port = mega.serial(1)
    port.peer_baud = baud
    mega.run_ms(1)
    port.send(bytes(n & 0xFF for n in range(4000)))
    end = mega.cycle + 4000 * 160_000_000 / baud
    mega.run_until(int(end) - 10)
    assert port.unsent == 1
    mega.run_cycles(200 * byte_cycles)
    sent = port.sent()
    assert bytes(entry.byte for entry in sent) == bytes(n & 0xFF for n in range(4000))
    assert sent[0].left - sent[0].written == byte_cycles
    assert {later.left - earlier.left for earlier, later in pairwise(sent)} == {byte_cycles}
    assert (mega.peek_int("arrived"), mega.peek_int("outOfOrder"), port.lost) == (4000, 0, 0)


def test_a_byte_of_a_slow_peer_is_heard_as_one_byte_for_each_of_its_falling_edges():
    mega = machine("stream", BAUD=57600, COUNT=0)
    port = mega.serial(1)
    port.peer_baud = 9600
    mega.run_ms(1)
    port.send(b"\x55")  # low and high in turn, six of the Mega's bits each
    mega.run_ms(3)
    assert (mega.peek_int("arrived"), mega.peek_int("sum")) == (5, 5 * 0xE0)


def test_a_slow_peer_hears_bytes_of_the_mega_as_pieces_of_one():
    mega = machine("stream", BAUD=115200, COUNT=3)  # 0, 1, 2, one right after the other
    port = mega.serial(1)
    port.peer_baud = 38400
    mega.run_ms(3)
    # The line, three of the Mega's bits to one of the peer's: 000 000 000 101 000 000 010 010 000 001, counting from
    # the first start bit. In the middle of each the peer hears a start bit, 0 0 0 0 0 1 1 0 0 ...
    assert port.sent_bytes() == bytes([0b01100000])


@pytest.mark.parametrize(("sent", "lost"), [(3, 0), (10, 7)])
def test_a_receiver_that_is_not_read_holds_three_bytes(sent, lost):
    mega = machine("late")
    mega.run_ms(1)
    mega.poke_int("deaf", 1)
    mega.run_ms(1)
    mega.serial(1).send(bytes(range(sent)))
    mega.run_ms(5)
    mega.poke_int("wake", 1)
    mega.run_ms(5)
    # The first two are in the buffer, the last is the one left in the shift register.
    survivors = list(range(sent))[:2] + list(range(sent))[2:][-1:]
    assert list(mega.peek("kept", len(survivors))) == survivors
    assert mega.peek_int("fetched") == len(survivors)
    assert mega.serial(1).lost == lost


def test_the_core_keeps_sixty_three_bytes_for_a_sketch_that_is_late():
    mega = machine("late")
    mega.run_ms(1)
    mega.serial(1).send(bytes(range(100)))
    mega.run_ms(30)
    mega.poke_int("wake", 1)
    mega.run_ms(1)
    assert mega.peek_int("fetched") == 63
    assert mega.peek("kept", 63) == bytes(range(63))
    assert mega.serial(1).lost == 0  # the chip lost none: the ring did


def test_time_passes_for_a_firmware_that_sleeps_and_millis_can_wrap():
    mega = machine("sleeper")
    mega.run_ms(2000)
    assert 1998 <= mega.peek_int("timer0_millis") <= 2000
    # Timer 0 overflows every 16,384 cycles; the core starts it within 2,000.
    assert mega.peek_int("timer0_overflow_count") == (2000 * MS - 1000) // 16384
    assert mega.cycle == 2000 * MS and mega.slept > 1960 * MS
    mega.poke_int("timer0_millis", 0xFFFFFFFF - 9)
    mega.run_ms(30)
    assert 18 <= mega.peek_int("seenMs") <= 21


def test_micros_runs_evenly_and_never_backwards():
    mega = machine("clock")
    mega.run_ms(500)
    assert mega.peek_int("readings") > 50_000
    assert mega.peek_int("backwards") == 0
    assert mega.peek_int("longestStepUs") <= 28
    assert mega.peek_int("lastUs") == pytest.approx(mega.now_us, abs=150)


def test_two_runs_are_equal_to_the_cycle_however_they_are_sliced():
    def run(slices):
        mega = machine("sleeper")
        port = mega.serial(1)
        port.peer_baud = 115200
        port.send(bytes(range(60)), at_cycle=3 * MS)
        for cycles in slices:
            mega.run_until(mega.cycle + cycles)
        mega.run_until(40 * MS)
        return port.sent(), mega.peek(0, mega.ram_end + 1), mega.deepest_stack, mega.slept

    whole = run([])
    assert len(whole[0]) == 60
    assert run([]) == whole
    assert run([1] * 5000 + [997] * 100 + [3] * 20_000) == whole


def test_cycles_of_a_known_delay_are_exact():
    mega = machine("cycles")
    mega.run_ms(3)
    watch = mega.watch("waitFourThousand")
    mega.poke_int("go", 1)
    mega.run_ms(2)
    # Two loads, 1,000 rounds of four cycles less the last branch, and a return of five.
    assert watch.calls.count == 1
    assert watch.calls.cycles == watch.calls.longest == 2 + 4 * 1000 - 1 + 5


def test_interrupts_inside_a_function_are_told_apart():
    mega = machine("cycles")
    mega.run_ms(3)
    watch = mega.watch("waitFourThousand")
    tick = mega.watch("__vector_23")
    for _ in range(8):
        mega.poke_int("go", 2)
        mega.run_ms(0.5)
    calls = watch.calls
    assert calls.count == 8
    assert calls.own_cycles == 8 * 4006
    assert calls.longest_own == 4006
    broke_in = calls.cycles - calls.own_cycles
    # Entry (5) and the jump from the vector table (3) are part of the interruption.
    assert broke_in > 0
    assert calls.longest == 4006 + tick.calls.longest + 8


def test_profile_attributes_every_cycle():
    mega = machine("sleeper")
    mega.run_ms(3)
    start = mega.cycle
    mega.start_profile()
    mega.run_ms(100)
    profile = mega.profile()
    assert profile.busy + profile.asleep == mega.cycle - start
    assert profile.cycles["__vector_23"] > 5000
    assert "(asleep)" in str(profile)


def test_measuring_changes_nothing_in_the_run():
    def run(measuring):
        mega = machine("sleeper")
        if measuring:
            mega.start_profile()
            mega.watch("main")
        mega.serial(1).send(b"hello", at_cycle=3 * MS)
        mega.run_ms(30)
        return mega.cycle, mega.serial(1).sent(), mega.peek(0, mega.ram_end + 1)

    assert run(True) == run(False)


def test_stack_depth_of_a_known_recursion_is_exact():
    mega = machine("depth")
    mega.run_ms(3)
    depths = {}
    for depth in (1, 2, 10, 100):
        mega.forget_stack()
        mega.poke_int("spDeepest", 0xFFFF)
        mega.poke_int("depth", depth)
        mega.run_ms(5)
        assert mega.peek_int("depth") == 0
        depths[depth] = mega.deepest_stack
        # The firmware's own reading of SP, in the innermost frame.
        assert mega.deepest_stack == mega.ram_end - mega.peek_int("spDeepest")
    frame = depths[2] - depths[1]
    assert frame >= 40 + 3
    assert depths[10] - depths[2] == 8 * frame
    assert depths[100] - depths[2] == 98 * frame


def test_globals_are_data_bss_and_noinit():
    elf = build_firmware("memory", [SOURCES / "memory.cpp"], library=False)
    rows = subprocess.run(["avr-size", "-A", elf], capture_output=True, text=True, check=True).stdout
    sizes = {row.split()[0]: int(row.split()[1]) for row in rows.splitlines() if row.startswith(".")}
    assert Mega(elf).globals_bytes == sizes[".data"] + sizes[".bss"] + sizes[".noinit"]


def test_reset_starts_the_firmware_again_and_keeps_noinit_and_eeprom():
    mega = machine("memory")
    mega.poke_int("starts", 40)
    mega.run_ms(20)
    assert mega.peek_int("starts") == 41
    assert mega.peek_int("counter") != 1234
    assert mega.peek_int("storedFirst") == 1
    assert mega.read_eeprom(3, 1) == b"\x29"
    assert mega.peek_int("causes") & 1  # PORF
    before = mega.cycle
    mega.reset()
    assert mega.cycle == before
    assert mega.resets == 1
    mega.run_ms(20)
    assert mega.peek_int("starts") == 42
    assert mega.peek_int("causes") & 2  # EXTRF
    assert mega.read_eeprom(0, 4) == b"\x01\x02\x03\x2a"


def test_a_byte_of_eeprom_takes_3_4_ms_and_the_next_waits_for_it():
    mega = machine("eeprom")
    writing = []
    for _ in range(300):
        mega.run_us(50)
        if mega.eeprom_writing not in writing:
            writing.append(mega.eeprom_writing)
    assert [address for address in writing if address is not None] == [100, 101, 102]
    first, second, third = struct.unpack("<3H", mega.peek("tookUs"))
    assert first < 50
    assert 3300 < second < 3450 and 3300 < third < 3450
    assert mega.peek_int("isDone") == 1 and mega.peek_int("wasReady") == 0
    assert mega.read_eeprom(100, 3) == b"QRS"
    assert mega.eeprom_writing is None


def test_the_watchdog_resets():
    mega = machine("halt")
    mega.run_ms(5)
    mega.poke_int("how", 3)
    mega.run_ms(10)
    assert mega.resets == 0
    mega.run_ms(10)
    assert mega.resets == 1


@pytest.mark.parametrize(
    ("how", "why"),
    [
        (2, r"halt\.elf crashed in main .* at 5\.\d+ ms: CORE: .* Address f000=01 out of ram$"),
        (4, r"flash address 0xe000\) at 5\.\d+ ms: it ran into erased flash"),
        (5, r"flash address 0x1fdfdfc\) at 5\.\d+ ms: it jumped beyond the flash"),
        (6, r"halt\.elf crashed in main .* at 5\.\d+ ms: it used flash beyond the end"),
    ],
)
def test_a_crash_says_where_and_why(how, why):
    mega = machine("halt")
    mega.run_ms(5)
    mega.poke_int("how", how)
    with pytest.raises(Crashed, match=why):
        mega.run_ms(1)


@pytest.mark.parametrize("mcu", ["atmega2560", "atmega328p"])
def test_every_instruction_is_the_same_fast_and_by_simavr(mcu):
    assert compare_instructions(mcu, seed=20260101, rounds=20) > 20 * 55_000


@pytest.mark.parametrize("name", ["sleeper", "stream", "clock", "depth"])
def test_a_run_is_the_same_fast_and_by_simavr(name):
    def run(plain):
        mega = machine(name, BAUD=115200, COUNT=200)
        if plain:
            mega.leave_all_to_simavr()
        port = mega.serial(1)
        port.peer_baud = 115200
        port.send(bytes(range(200)), at_cycle=3 * MS)
        seen = []
        for _ in range(60):
            mega.run_us(499)
            if name == "depth":
                mega.poke_int("depth", 7)
            seen.append((mega.cycle, port.sent(), mega.peek(0, mega.ram_end + 1), mega.deepest_stack, mega.slept))
        return seen

    assert run(plain=False) == run(plain=True)


def test_a_loop_that_waits_is_the_same_without_its_rounds():
    def run(plain):
        mega = machine("waits")
        if plain:
            mega.leave_all_to_simavr()
        port = mega.serial(1)
        seen = []
        for number in range(900):
            mega.run_us(101)
            if number % 47 == 0:
                mega.poke_int("asked", 1)
            if number % 83 == 0:
                mega.poke_int(0x2C, mega.peek_int(0x2C) ^ 1 << 4)  # PINE, bit 4: pin 2
            if number % 91 == 0:
                port.send(b"some", at_cycle=mega.cycle + 12_345)
                mega.serial(2).send(b"thing", at_cycle=mega.cycle + 1_234)
            if number % 300 == 200:
                mega.poke_int("timed", not mega.peek_int("timed"))
            if number % 200 == 100:
                mega.poke_int("tuned", not mega.peek_int("tuned"))
            if number == 400:
                mega.reset()
            seen.append((mega.cycle, port.sent(), mega.peek(0, mega.ram_end + 1), mega.deepest_stack))
        counts = [mega.peek_int(name) for name in
                  ("heard", "tens", "pressed", "answered", "polled", "ticks", "overflows")]
        assert min(counts) > 0, counts
        return seen

    assert run(plain=False) == run(plain=True)


def test_a_name_that_is_not_there_is_refused_with_what_is_near():
    mega = machine("late")
    with pytest.raises(NoSuchSymbol, match="no fetchd in .* near it: fetched"):
        mega.peek("fetchd")
    with pytest.raises(ValueError, match="is a variable, not a function"):
        mega.watch("fetched")


def test_hex_runs_like_the_elf(tmp_path):
    elf = build_firmware("sleeper", [SOURCES / "sleeper.cpp"], library=False)
    hex_file = tmp_path / "sleeper.hex"
    subprocess.run(["avr-objcopy", "-O", "ihex", "-R", ".eeprom", elf, hex_file], check=True)
    runs = []
    for file in (elf, hex_file):
        mega = Mega(file)
        mega.serial(1).send(b"abc", at_cycle=3 * MS)
        mega.run_ms(10)
        runs.append((mega.serial(1).sent(), mega.deepest_stack))
    assert runs[0] == runs[1]
    assert len(runs[0][0]) == 3


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"hello", "neither an ELF nor an Intel HEX"),
        (b"\x7fELFxxxxxxxxxxxx", "damaged ELF"),
        (b":0400000001020304F3\n:00000001FF\n", "checksum"),
        (b":0500000001020304F1\n:00000001FF\n", "says 5 bytes and has 4"),
        (b":0400000001020304F2\n", "end record"),
    ],
)
def test_a_file_that_is_no_firmware_is_refused(tmp_path, content, why):
    file = tmp_path / "firmware"
    file.write_bytes(content)
    with pytest.raises(BadImage, match=why):
        Mega(file)


@pytest.mark.parametrize(("mcu", "ports"), [("atmega2560", {0, 1, 2, 3}), ("atmega328p", {0}), ("atmega32u4", {1})])
def test_each_board_has_its_own_serial_ports(mcu, ports):
    mega = machine("spin", mcu)
    assert mega.mcu == mcu
    mega.run_ms(2)
    assert mega.peek_int("rounds") > 100
    for number in range(4):
        if number in ports:
            assert mega.serial(number).sent() == []
        else:
            with pytest.raises(ValueError, match=f"an {mcu} has no Serial"):
                mega.serial(number)


def test_firmware_that_warns_is_not_built(tmp_path):
    source = tmp_path / "warns.cpp"
    source.write_text("#include <Arduino.h>\nvoid setup() { int unused; }\nvoid loop() {}\n")
    with pytest.raises(FirmwareNotBuilt, match="unused"):
        build_firmware("warns", [source], library=False)
