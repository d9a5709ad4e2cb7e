"""What fits which board, and is promised to."""

from __future__ import annotations

# What its comment says does not fit; if it does one day, its test says so.
TOO_LARGE = {
    ("PlanConsole", "leonardo"),
    ("PlanConsole", "nano"),
    ("PlanConsole", "uno"),
    ("StartButton", "leonardo"),
    ("StartButton", "nano"),
    ("StartMission", "leonardo"),
    ("StartMission", "nano"),
    ("StartMission", "uno"),
    ("NextWaypoint", "leonardo"),
    ("NextWaypoint", "nano"),
    ("NextWaypoint", "uno"),
    ("PlanFromSd", "leonardo"),
    ("FlyByButtons", "leonardo"),
    ("FlyByButtons", "nano"),
    ("FollowBeacon", "leonardo"),
    ("FollowBeacon", "nano"),
    ("UploadByFile", "leonardo"),
    ("UploadByFile", "nano"),
    ("WorkAtWaypoints", "leonardo"),
    ("WorkAtWaypoints", "nano"),
    ("WorkAtWaypoints", "uno"),
}

# It fits by less than another version of the compiler may take: the documents and the workflow do not promise it.
NOT_PROMISED = TOO_LARGE | {("StartButton", "uno"), ("FlyByButtons", "uno")}
