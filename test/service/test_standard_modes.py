"""Modes by their standard names, and the autopilot's list of modes. host/units/standard_modes.cpp has each answer."""

from __future__ import annotations

from simulation.fake_autopilot.px4 import MODES, STANDARD_MODES, custom_mode
from simulation.modes import ModeBench

LAND, CRUISE = 7, 3


def test_px4_sets_its_standard_modes_and_lists_all_of_its_modes():
    px4 = ModeBench("PX4")
    before = (px4.autopilot.main_mode, px4.autopilot.sub_mode)
    assert px4.order("set", CRUISE) == "CommandFailed"  # this aircraft does not have it
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == before
    assert px4.order("set", LAND) == "Done"
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == STANDARD_MODES[LAND]
    assert px4.entry.current == LAND
    standard = {mode: number for number, mode in STANDARD_MODES.items()}
    for number, (mode, name, can_be_set) in enumerate(MODES, 1):
        assert px4.order("read", number) == "Done"
        assert px4.entry == (standard.get(mode, 0), len(MODES), custom_mode(*mode), can_be_set, LAND, name)
    assert px4.order("read", len(MODES) + 1) == "CommandDenied"
    hold = [name for _, name, _ in MODES].index("Hold") + 1
    assert (px4.order("read", hold), px4.order("custom")) == ("Done", "Done")
    assert (px4.autopilot.main_mode, px4.autopilot.sub_mode) == MODES[hold - 1][0]


def test_ardupilot_has_no_standard_modes_and_a_newer_one_lists_its_own():
    """As ArduCopter 4.8-dev: each has its own number and a name. A number beyond the list is accepted in silence."""
    older = ModeBench("ArduPilot")
    assert (older.order("set", LAND), older.order("read", 1)) == ("CommandUnsupported", "CommandFailed")
    bench = ModeBench("ArduPilot", lists_modes=True)
    modes = bench.autopilot.kind.modes
    for number, (name, custom) in enumerate(modes.items(), 1):
        assert bench.order("read", number) == "Done"
        assert bench.entry == (0, len(modes), custom, True, 0, name)
    assert bench.order("read", len(modes) + 1) == "Unconfirmed"
    assert bench.order("set", LAND) == "CommandUnsupported"
    assert bench.order("read", list(modes).index("GUIDED") + 1) == "Done"
    assert (bench.order("custom"), bench.autopilot.mode) == ("Done", "GUIDED")
