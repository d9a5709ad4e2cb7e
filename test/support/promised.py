"""What fits which board, and is promised to."""

from __future__ import annotations

# What its comment says does not fit; if it does one day, its test says so.
TOO_LARGE = {(example, board) for boards, examples in (
    ("leonardo", "StartMission PlanFromSd GoToPlaces"),
    ("leonardo nano", "StartButton NextWaypoint UploadByFile"),
    ("leonardo nano uno", "PlanConsole FlyByButtons FollowBeacon WorkAtWaypoints"),
) for board in boards.split() for example in examples.split()}  # fmt: skip

# It fits by less than another version of the compiler may take: the documents and the workflow do not promise it.
NOT_PROMISED = TOO_LARGE | {("StartMission", "nano")}
