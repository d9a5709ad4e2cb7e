"""What fits which board, and is promised to."""

from __future__ import annotations

# What its comment says does not fit; if it does one day, its test says so.
TOO_LARGE = {
    ("PlanConsole", "leonardo"),
    ("PlanConsole", "nano"),
    ("StartButton", "leonardo"),
    ("StartMission", "leonardo"),
    ("NextWaypoint", "leonardo"),
    ("PlanFromSd", "leonardo"),
    ("FlyByButtons", "leonardo"),
    ("FollowBeacon", "leonardo"),
    ("UploadByFile", "leonardo"),
    ("WorkAtWaypoints", "leonardo"),
    ("WorkAtWaypoints", "nano"),
    ("WorkAtWaypoints", "uno"),
}

# It fits by less than another version of the compiler may take: the documents and the workflow do not promise it.
NOT_PROMISED = TOO_LARGE | {("PlanConsole", "uno"), ("StartMission", "nano"), ("NextWaypoint", "nano")}
