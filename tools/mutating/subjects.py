"""What is mutated, and which tests must notice: the one place that names them.

A name stands for the .cpp and the .h of that name, wherever under src they are; a unit for the file of that name
under test/host/units.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from simulation.firmware import LIBRARY
from simulation.host_build import UNITS


class Subject(NamedTuple):
    name: str
    units: tuple[str, ...] = ()  # what tests it alone, or with the parts next to it
    is_flown: bool = False  # whether flights are to find what these do not


# The engines: what needs neither a stream nor a clock.
ENGINES = (
    Subject("UploadTransfer", ("upload_transfer",)),
    Subject("DownloadTransfer", ("download_transfer",)),
    Subject("ClearTransfer", ("clear_transfer",)),
    Subject("CommandTransfer", ("command_transfer",)),
    Subject("CommandLog", ("command_log",)),
    Subject("StartTransfer", ("start_transfer",)),
    Subject("ModeOrder", ("mode_order",)),
    Subject("FrameParser", ("frame_parser",)),
    Subject("ItemNumbers", ("item_numbers", "wire_plan")),
    Subject("WirePlan", ("wire_plan",)),
    Subject("Comparison", ("comparison",)),
    Subject("Commands", ("commands", "comparison", "wire_plan")),
    Subject("Rules", ("commands", "comparison", "wire_plan")),
    Subject("KeptValue", ("kept_value",)),
    Subject("OpaqueId", ("opaque_id",)),
    Subject("BackOff", ("client_upload",)),
    Subject("PartialUpload", ("client_parts",)),
)

# The tests of Steering, the cheapest first.
STEERING = (
    "steering_refusals", "steering_orders", "steering_arrival", "steering_trouble", "steering_takeover", "steering",
)  # fmt: skip

# The tests of PlanFiles.
PLAN_FILES = (
    "plan_files", "plan_files_next", "plan_files_left_open", "plan_files_requests", "plan_files_lossy",
)  # fmt: skip

# What is around them.
AROUND = (
    # text
    Subject("LongNumber", ("long_number", "decimal_text")),
    Subject("DecimalText", ("decimal_text",)),
    Subject("WaypointsText", ("waypoints_text",)),
    Subject("WaypointsSource", ("waypoints_source",)),
    # storage
    Subject("EepromPlan", ("eeprom_plan", "eeprom_of_a_board")),
    Subject("EepromTimestamps", ("eeprom_timestamps", "eeprom_of_a_board")),
    Subject("Eeprom", ("eeprom_of_a_board",)),
    # client
    Subject("AskVehicle", ("client_modes",), is_flown=True),
    Subject("Clear", ("client_clear",)),
    Subject(
        "Client",
        (
            "client_calls",
            "client_upload_ends",
            "client_verify",
            "client_late_answers",
            "client_readback",
            "client_start",
            "client_clear",
            "client_fence",
            "client_commands",
        ),
        is_flown=True,
    ),
    Subject("Command", ("client_commands", "client_modes", "client_current_item", "client_start"), is_flown=True),
    Subject("CommandForm", ("client_command_form",)),
    Subject("Download", ("client_download",)),
    Subject("Ensure", ("client_ensure", "client_looks", "client_mission_name")),
    Subject("Fence", ("client_fence", "areas")),
    Subject("FloatItems", ("client_parts", "client_download")),
    Subject("Kept", ("client_kept_value",)),
    Subject("Operation", ("client_clear", "client_verify", "parameters")),
    Subject("OtherPlan", ("client_mission_name", "client_start"), is_flown=True),
    Subject("PlanPort", ("client_ensure", *PLAN_FILES)),
    Subject(
        "Port",
        ("client_mission_name", "steering", "parameters", "client_commands", "client_upload_ends", "plan_files"),
        is_flown=True,
    ),
    Subject(
        "Read",
        (
            "client_verify",
            "client_readback",
            "client_download",
            "client_late_answers",
            "client_mission_name",
            "plan_files",
        ),
    ),
    Subject("Start", ("client_start", "client_mission_name"), is_flown=True),
    Subject("ContinueAfter", ("client_readback", "client_parts", "client_late_answers")),
    Subject(
        "Upload",
        ("client_upload_ends", "client_readback", "client_mission_name", "client_late_answers", "client_parts"),
    ),
    Subject("VerifyAndStart", ("client_verify_and_start",), is_flown=True),
    Subject("WorthRetry", ("status",)),
    # service, files, telemetry, payload, steering
    Subject("Adjustments", ("adjustments",)),
    Subject("AttitudeListener", ("listener_values", "telemetry_listeners")),
    Subject("BatteryListener", ("listener_values", "telemetry_listeners")),
    Subject("EitherListener", ("telemetry_listeners",)),
    Subject("EstimatorListener", ("fitness_listeners", "listener_values")),
    Subject("FileFrame", ("plan_files",)),
    Subject("FitReasons", ("fitness_listeners",)),
    Subject("GpsListener", ("listener_values", "telemetry_listeners")),
    Subject("HealthListener", ("fitness_listeners", "listener_values")),
    Subject("HomeListener", ("home_listener",)),
    Subject("HudListener", ("listener_values", "telemetry_listeners")),
    Subject("LinkDoctor", ("link_doctor",)),
    Subject("Listener", ("telemetry_listeners", "message_listener", "velocity_vehicles")),
    Subject("MessageIntervals", ("message_intervals", "telemetry_listeners", "telemetry_pause")),
    Subject("MessageListener", ("message_listener",)),
    Subject("MissionFollower", ("mission_follower", "message_intervals"), is_flown=True),
    Subject("MovingTarget", ("moving_target", "velocity_end", "velocity_target"), is_flown=True),
    Subject("OutgoingFields", ("payload_messages", "sensor_messages")),
    Subject("Parameters", ("parameters",)),
    Subject("Payload", ("payload",)),
    Subject("PayloadMessages", ("payload_messages",)),
    Subject("PlanFiles", PLAN_FILES),
    Subject("PlanFilesEnsuring", PLAN_FILES),
    Subject("PlanFilesReading", PLAN_FILES),
    Subject("PlanFilesWriting", PLAN_FILES),
    Subject("PositionListener", ("listener_values",)),
    Subject("RadioListener", ("listener_values", "telemetry_listeners")),
    Subject("RcListener", ("listener_values", "telemetry_listeners")),
    Subject("SensorMessages", ("sensor_messages",)),
    Subject("StandardModes", ("standard_modes",)),
    Subject("Steering", STEERING, is_flown=True),
    Subject("SteeringControl", STEERING, is_flown=True),
    Subject("SteeringNumbers", STEERING, is_flown=True),
    Subject("SteeringOrders", (*STEERING, "adjustments", "velocity_target"), is_flown=True),
    Subject("SteeringRefusals", STEERING, is_flown=True),
    Subject("SteeringSteps", STEERING, is_flown=True),
    Subject("TelemetryListener", ("telemetry_listeners", "listener_values")),
    Subject("TelemetryPause", ("telemetry_pause",)),
    Subject("TextListener", ("text_listener",)),
    Subject("VelocityTarget", ("velocity_target", "velocity_vehicles")),
    Subject("VibrationListener", ("fitness_listeners", "listener_values")),
    Subject("WaypointListener", ("listener_values", "telemetry_listeners")),
    Subject("WindListener", ("listener_values", "telemetry_listeners")),
)

SUBJECTS = ENGINES + AROUND

# Tests of a whole MissionClient on a stream in memory: they see what a part's own tests do not.
CLIENT_UNITS = ("client_upload", "client_reading")

# Flown by the client as it ships, against models of autopilots. Each takes less than a second.
FLOWN = (
    "Copter all each 100",
    "Rover all each 100",
    "PX4 all each 100",
    "Copter all each 100 --own 1",
    "PX4 all each 100 --own 1",
    "Copter all random 12 --loss 30",
    "PX4 all random 12 --loss 30",
)

# Explored when all else has passed. Each takes less than a second.
EXPLORED = (
    "ArduPilot upload-in-doubt 2",
    "LateArduPilot upload-in-doubt 2",
    "PX4 upload-in-doubt 2",
    "PX4 upload 2",
    "PX4 upload-verified 2",
    "ArduPilot download 0 --held 3",
    "PX4 download 0 --held 3 --faults 1",
    "ArduPilot verify 2 --held 2 --held-plan 1",
    "ArduPilot verify 2 --held 3",
    "ArduPilot upload-in-doubt 1 --faults 1",
    "PX4 upload-in-doubt 1 --faults 1",
    "ArduPilot upload-verified 2 --reboots 1",
    "ArduPilot upload-in-doubt 1 upload-in-doubt 2 --losses 2",
    "PX4 upload-in-doubt 2 upload-in-doubt 1 --losses 2 --resets 1",
)


def subjects(names: list[str] | None = None) -> list[Subject]:
    """Those named, by file or without its ending; all by default. A file without tests of its own may be named too."""
    known = {subject.name: subject for subject in SUBJECTS}
    found = []
    for name in [Path(name).stem for name in names or known]:
        files_of(name)
        found.append(known.get(name) or Subject(name))
    return list(dict.fromkeys(found))


def files_of(name: str) -> list[Path]:
    """Its source and its header. Raises ValueError if there is none, or two of one name."""
    files = [list(LIBRARY.rglob(name + ending)) for ending in (".cpp", ".h")]
    if not any(files) or any(len(same) > 1 for same in files):
        raise ValueError(f"there is not exactly one {name}.h or {name}.cpp under {LIBRARY}")
    return [file for same in files for file in same]


def units_of(subject: Subject) -> list[Path]:
    """The files of the tests for it, the cheapest first."""
    return [UNITS / f"{name}.cpp" for name in dict.fromkeys((*subject.units, *CLIENT_UNITS))]
