"""The fake autopilots keep and refuse each of 11,900 random items as the real ones did."""

from __future__ import annotations

import pytest

from readbacks import ACCEPTED, VEHICLES, Row, kept, rows
from simulation.fake_autopilot import FENCE, ardupilot_rewriting, mavlink


@pytest.mark.parametrize("recording", VEHICLES)
def test_every_random_item_is_kept_or_refused_as_by_the_real_autopilot(recording):
    wrong = []
    for row in rows(recording):
        result, held = kept(recording, row.mission_type, row.sent)
        if row.mission_type == FENCE and row.result != ACCEPTED:
            continue  # said of the whole plan; some item of it
        # A jump out of the plan is refused by who knows the plan.
        is_jump = row.sent.command == mavlink.MAV_CMD_DO_JUMP and row.result == mavlink.MAV_MISSION_ERROR
        if not is_jump and result != row.result:
            wrong.append((row, result))
        elif row.read is not None and not held.same_as(row.read._replace(current=0)):
            wrong.append((row, held))
    assert not wrong, f"{len(wrong)} of {len(rows(recording))}, the first: {wrong[:3]}"


@pytest.mark.parametrize("recording", VEHICLES)
def test_every_fence_is_taken_or_refused_as_by_the_real_autopilot(recording):
    plans: dict[int, list[Row]] = {}
    for row in rows(recording):
        if row.mission_type == FENCE:
            plans.setdefault(row.plan, []).append(row)
    for plan in plans.values():
        results, held = zip(*(kept(recording, FENCE, row.sent) for row in plan), strict=True)
        refusal = next((result for result in results if result != ACCEPTED), ACCEPTED)
        if refusal == ACCEPTED and recording != "px4" and not ardupilot_rewriting.fence_is_whole(list(held)):
            refusal = mavlink.MAV_MISSION_ERROR
        assert refusal == plan[0].result, plan
