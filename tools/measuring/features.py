"""What each feature adds to a sketch: flash and globals, feature by feature. A row of SKETCHES is one feature."""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

from building import ROOT, elf_sizes
from simulation.firmware import build_firmware, exclusive

from .documents import aligned, rounded
from .record import Section

WRITTEN = ROOT / "build" / "measured"
CLIENT = """\
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);"""
UPLOAD = "autopilot.upload(inFlash(survey));"
UPDATE = "autopilot.update();"
SEEN = {"seen8": "uint8_t", "seen16": "uint16_t", "seen32": "int32_t"}  # what a sketch puts its values into


class Sketch(NamedTuple):
    """An upload of a plan in flash, and what stands there instead or besides."""

    label: str  # in the table
    declares: str = ""  # after the client
    before: str = ""  # the upload
    setup: str = UPLOAD
    loop: str = UPDATE
    then: str = ""  # after update()
    once_aboard: str = ""  # when the upload is accepted
    client: str = CLIENT
    header: str = "MavMission.h"
    macros: dict[str, int] = {}  # of sketch and library

    @property
    def text(self) -> str:
        loop = f"if (autopilot.update() == Status::Accepted) {self.once_aboard}" if self.once_aboard else self.loop
        text = " ".join((self.declares, loop, self.then))
        seen = "\n".join(f"volatile {kind} {name};" for name, kind in SEEN.items() if f"{name} =" in text)
        return f"""\
#include <Arduino.h>
#include <{self.header}>
using namespace mavmission;
{self.client}
{seen}
{self.declares}
void setup() {{
Serial1.begin(57600);
{self.before}
{self.setup}
}}
void loop() {{
{loop}
{self.then}
}}
"""


PLAIN = Sketch("Uploads a plan from flash, and reads it back when the answer is in doubt")
SKETCHES = (
    Sketch("Opens Serial1, and nothing else", setup="", loop="Serial1.read();", client=""),
    Sketch("A client that finds the autopilot and keeps the link alive", setup=""),
    Sketch("Uploads a plan from flash by the autopilot's answer alone, uploadWithoutReadback()",
           setup="autopilot.uploadWithoutReadback(inFlash(survey));"),
    PLAIN,
    Sketch("The same with a progress callback", "void progress(void*, uint16_t done, uint16_t) { seen16 = done; }",
           before="autopilot.onProgress(progress);"),
    Sketch("The upload with a download behind it",
           "bool store(void*, uint16_t, const MissionItem& item) { seen8 = item.command; return true; }",
           once_aboard="autopilot.download(toFunction(store));"),
    Sketch("The upload with a verification behind it", once_aboard="autopilot.verify(inFlash(survey));"),
    Sketch("The upload, and start() when it is aboard", once_aboard="autopilot.start();"),
    Sketch("The upload, and verifyAndStart() when it is aboard",
           once_aboard="autopilot.verifyAndStart(inFlash(survey));"),
    Sketch("The upload with a MissionFollower", "MissionFollower follower(autopilot);",
           then="seen16 = follower.currentItem();"),
    Sketch("The upload with its status printed in words",
           loop="const Status status = autopilot.update(); if (isEnd(status)) Serial1.println(toString(status));"),
    Sketch("The upload, to Betaflight too", macros={"MAVMISSION_GENERIC_FIRMWARE": 1}),
    Sketch("The upload, to iNav too", macros={"MAVMISSION_GENERIC_FIRMWARE": 2}),
    Sketch("The upload, to ArduPilot alone: MAVMISSION_ONLY_ARDUPILOT", macros={"MAVMISSION_ONLY_ARDUPILOT": 1}),
    Sketch("The upload, to PX4 alone: MAVMISSION_ONLY_PX4", macros={"MAVMISSION_ONLY_PX4": 1}),
    Sketch("The upload on a signed link",
           "const uint8_t secret[32] PROGMEM = {0x8f, 0x1c}; EepromTimestamps timestamps(0);",
           before="autopilot.signWith(keyInFlash(secret), 7, timestamps);", macros={"MAVMISSION_SIGNING": 1}),
    Sketch("Two clients, each with an autopilot and a port of its own",
           setup="Serial2.begin(57600); first.upload(inFlash(survey)); second.upload(inFlash(survey));",
           loop="first.update(); second.update();",
           client="constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()}; "
                  "MissionClient first(Serial1); MissionClient second(Serial2);"),
    Sketch("The upload with retryWhenBusy()", before="autopilot.retryWhenBusy(60);"),
    Sketch("The upload with useMissionItemFallback()", before="autopilot.useMissionItemFallback();"),
    Sketch("The upload with TelemetryPause", "TelemetryPause quiet(autopilot);",
           loop="quiet.update(); autopilot.update();"),
    Sketch("The upload with a LinkDoctor", "LinkDoctor doctor(autopilot);",
           loop="seen8 = static_cast<uint8_t>(doctor.update()); autopilot.update();"),
    Sketch("The upload of a .waypoints text by a WaypointsSource, the stream below it apart",
           "struct Text : Stream { bool seek(uint32_t) { return true; } int available() override { return 1; "
           "} int peek() override { return GPIOR0; } int read() override { return GPIOR0; "
           "} size_t write(uint8_t) override { return 0; } } text; WaypointsSource plan(text);", setup="plan.begin();",
           loop="if (plan.state() == WaypointsSource::State::Reading && plan.update() "
                "== WaypointsSource::State::Good) { autopilot.upload(plan.source()); } autopilot.update();"),
    Sketch("The upload of a plan that an EepromPlan keeps", "EepromPlan plan;",
           setup="plan.begin(); autopilot.upload(plan.source());"),
    Sketch("The same with a PlanConsole on Serial, Serial itself included",
           "EepromPlan plan; PlanConsole console(Serial, autopilot, plan);",
           setup="Serial.begin(115200); plan.begin();", loop="plan.update(); console.update(); autopilot.update();",
           header="MavMissionConsole.h"),
    Sketch("The same with offerAll(): every command", "EepromPlan plan; PlanConsole console(Serial, autopilot, plan);",
           setup="Serial.begin(115200); plan.begin(); console.offerAll();",
           loop="plan.update(); console.update(); autopilot.update();", header="MavMissionConsole.h"),
    Sketch("The upload with a verification by file behind it, PlanFiles", "PlanFiles files(autopilot);",
           once_aboard="files.verify(inFlash(survey));"),
    Sketch("The upload with a PositionListener", "PositionListener position(autopilot, 500);",
           then="if (position.isNew()) seen32 = position.place().latitude.e7() + position.aboveHomeMm();"),
    Sketch("The upload with an AttitudeListener", "AttitudeListener attitude(autopilot, 500);",
           then="if (attitude.isNew()) seen32 = attitude.roll().e7();"),
    Sketch("The upload by file, PlanFiles", "PlanFiles files(autopilot);", setup="files.upload(inFlash(survey));"),
    Sketch("The upload with a BatteryListener", "BatteryListener battery(autopilot, 500);",
           then="if (battery.isNew()) seen32 = battery.voltageMv() + battery.remainingPercent();"),
    Sketch("The upload with a HudListener", "HudListener hud(autopilot, 500);",
           then="if (hud.isNew()) seen32 = hud.groundSpeedCmS() + hud.climbCmS();"),
    Sketch("The upload with a RadioListener", "RadioListener radio(autopilot);",
           then="if (radio.isNew()) seen32 = radio.rssi();"),
    Sketch("The upload with a WaypointListener", "WaypointListener target(autopilot, 500);",
           then="if (target.isNew()) seen32 = target.distanceM();"),
    Sketch("The upload with a GpsListener", "GpsListener gps(autopilot, 500);",
           then="if (gps.isNew()) seen32 = gps.satellites();"),
    Sketch("The upload with an RcListener", "RcListener rc(autopilot, 500);",
           then="if (rc.isNew()) seen32 = rc.channelUs(7);"),
    Sketch("The upload with a HomeListener, which needs a longer buffer", "HomeListener home(autopilot, 5000);",
           then="if (home.isNew()) seen32 = home.aboveSeaLevelMm();", macros={"MAVMISSION_MAX_PAYLOAD": 60}),
    Sketch("The upload with the five listeners of telemetry that need no longer buffer",
           "PositionListener position(autopilot, 500); AttitudeListener attitude(autopilot, 500); "
           "BatteryListener battery(autopilot, 500); GpsListener gps(autopilot, 500); RcListener rc(autopilot, 500);",
           then="if (position.isNew()) seen32 = position.place().latitude.e7() + position.aboveHomeMm(); "
                "if (attitude.isNew()) seen32 = attitude.roll().e7(); "
                "if (battery.isNew()) seen32 = battery.voltageMv() + battery.remainingPercent(); "
                "if (gps.isNew()) seen32 = gps.satellites(); if (rc.isNew()) seen32 = rc.channelUs(7);"),
    Sketch("The upload with a HealthListener", "HealthListener health(autopilot, 500);",
           then="seen8 = static_cast<uint8_t>(health.fitness());"),
    Sketch("The upload with an EstimatorListener", "EstimatorListener estimator(autopilot, 500);",
           then="seen8 = static_cast<uint8_t>(estimator.fitness());"),
    Sketch("The upload with a VibrationListener", "VibrationListener vibration(autopilot, 500);",
           then="seen8 = static_cast<uint8_t>(vibration.fitness());"),
    Sketch("The upload with a WindListener: speed and direction", "WindListener wind(autopilot, 500);",
           then="if (wind.isNew()) seen16 = wind.speedCmS() + wind.fromDeg();"),
    Sketch("The upload with a TextListener",
           "TextListener texts(autopilot); void take(void*, uint8_t severity, const char*) { seen8 = severity; }",
           before="texts.onText(take);"),
    Sketch("The upload with modeName()", then="Serial.println(autopilot.modeName());"),
    Sketch("The upload with a Vehicle: battery()", "Vehicle<autopilot> vehicle;",
           then="if (vehicle.battery().isNew()) seen32 = vehicle.battery().voltageMv() "
                "+ vehicle.battery().remainingPercent();"),
    Sketch("The upload with a Vehicle: position(), battery(), gps()", "Vehicle<autopilot> vehicle;",
           then="if (vehicle.position().isNew()) seen32 = vehicle.position().aboveHomeMm(); "
                "if (vehicle.battery().isNew()) seen32 = vehicle.battery().voltageMv() "
                "+ vehicle.battery().remainingPercent(); "
                "if (vehicle.gps().isNew()) seen32 = vehicle.gps().satellites();"),
    Sketch("The upload with a Vehicle: fitness()", "Vehicle<autopilot> vehicle;",
           then="seen8 = static_cast<uint8_t>(vehicle.fitness());"),
    Sketch("The upload with a Vehicle: all of it, fitness(), texts() and modeName(), too",
           "Vehicle<autopilot> vehicle;",
           then="if (vehicle.position().isNew()) seen32 = vehicle.position().aboveHomeMm(); "
                "if (vehicle.attitude().isNew()) seen32 = vehicle.attitude().roll().e7(); "
                "if (vehicle.battery().isNew()) seen32 = vehicle.battery().voltageMv() "
                "+ vehicle.battery().remainingPercent(); "
                "if (vehicle.gps().isNew()) seen32 = vehicle.gps().satellites(); "
                "if (vehicle.hud().isNew()) seen32 = vehicle.hud().groundSpeedCmS() + vehicle.hud().climbCmS(); "
                "if (vehicle.waypoint().isNew()) seen32 = vehicle.waypoint().distanceM(); "
                "if (vehicle.wind().isNew()) seen32 = vehicle.wind().speedCmS() + vehicle.wind().fromDeg(); "
                "seen32 = static_cast<uint8_t>(vehicle.fitness()); "
                "if (vehicle.texts().isNew()) seen32 = vehicle.texts().lastSeverity(); "
                "Serial.println(vehicle.modeName());"),
    Sketch("The upload with Parameters: one read, one set", "Parameters parameters(autopilot);",
           loop='const Status status = autopilot.update(); '
                'if (status == Status::Accepted) parameters.read(F("FENCE_ENABLE")); '
                'if (status == Status::Done && parameters.whole() == 0) parameters.setWhole(F("FENCE_ENABLE"), 1); '
                'seen32 = parameters.whole();'),
    Sketch("A client with a Steering that calls landNow() and no more", "Steering steering(autopilot);",
           setup="steering.landNow();"),
    Sketch("A client with a Steering: takeOff(), goTo(), hasArrived(), returnHome()", "Steering steering(autopilot);",
           setup="steering.takeOff(20_m);",
           loop="if (autopilot.update() == Status::Done) "
                "steering.goTo(LatLon{-35.3630000_deg, 149.1652374_deg}, 20_m); "
                "if (steering.hasArrived()) steering.returnHome();"),
    Sketch("A client with a Steering and a MovingTarget: start(), renew(), stop()",
           "Steering steering(autopilot); MovingTarget target(steering);", setup="steering.takeOff(20_m);",
           loop="target.update(); "
                "const LatLon place = {Degrees::fromE7(-353630000 + analogRead(0)), 149.1652374_deg}; "
                "if (autopilot.update() == Status::Done) target.start(place, 20_m); "
                "if (target.renew(place, 20_m) == Status::NotRenewed) target.stop(); "
                "if (steering.hasArrived()) steering.returnHome();"),
    Sketch("A client with a Steering and a VelocityTarget: start(), renew(), stop()",
           "Steering steering(autopilot); VelocityTarget velocity(steering);", setup="steering.takeOff(20_m);",
           loop="velocity.update(); "
                "const BodyVelocity ahead = BodyVelocity(2_mps).turning(DegreesPerSecond(analogRead(0))); "
                "if (autopilot.update() == Status::Done) velocity.start(ahead); "
                "if (velocity.renew(ahead) == Status::NotRenewed) velocity.stop(); "
                "if (steering.hasArrived()) steering.returnHome();"),
    Sketch("The upload with a Payload",
           "PayloadAnswer carryOut(void*, const PayloadCommand& command) { "
           "return command.id == 211 ? PayloadAnswer::Accepted : PayloadAnswer::Unsupported; "
           "} Payload payload(autopilot, carryOut);", then="payload.update();"),
    Sketch("The upload with a NamedValue, sent again and again", 'NamedValue weight("weight");',
           then="if (!autopilot.isSent()) return; weight.set(3.25f); autopilot.sendMessage(weight);"),
    Sketch("The upload with StandardModes: one set, one read", "StandardModes modes(autopilot);",
           loop="const Status status = autopilot.update(); "
                "if (status == Status::Accepted) modes.set(StandardMode::Mission); "
                "if (status == Status::Done) modes.read(1); seen8 = static_cast<uint8_t>(modes.current());"),
)  # fmt: skip


def built(sketch: Sketch, *, library: bool | Path = True) -> Path:
    """Its ELF, with the library or a changed copy of it."""
    name = re.sub(r"\W+", "_", sketch.label)
    source = WRITTEN / f"{name}.cpp"
    with exclusive(source):
        if not source.exists() or source.read_text() != sketch.text:
            source.write_text(sketch.text)
    return build_firmware(f"measured_{name}", [source], sketch.macros, library=library)


def features() -> Section:
    """By its label, in the order of the list, what each sketch takes on a Mega [bytes]."""
    return {sketch.label: dict(zip(("flash", "globals"), elf_sizes(built(sketch)), strict=True)) for sketch in SKETCHES}


def table(sizes: Section) -> str:
    """What an upload takes, and how much more each feature."""
    base = sizes[PLAIN.label]
    more = {label: [size[part] - base[part] for part in base] for label, size in sizes.items()}
    listeners = [label for label in sizes if re.fullmatch(r"The upload with an? \w+Listener", label)]
    lines = [["on a Mega", "flash", "RAM"]]
    for label, added in more.items():
        if label == listeners[0]:
            parts = zip(*(more[listener] for listener in listeners), strict=True)
            ranges = (f"{signed(min(part))} to {signed(max(part))}" for part in parts)
            lines.append(["With one listener of telemetry, such as a PositionListener", *ranges])
        elif label not in listeners:
            whole = [f"**{rounded(size)}**" for size in base.values()]
            cells = [signed(size) for size in added] if any(added) else whole
            lines.append([re.sub("^The upload with", "With", label), *cells])
    return aligned(lines, left=1)


def signed(size: float) -> str:
    return f"{'-' if size < 0 else '+'}{rounded(abs(size))}"
