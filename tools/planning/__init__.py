"""Plans in files: QGroundControl's .plan and Mission Planner's .waypoints, read, checked, converted, shown and drawn.

    from planning import read_plan
    plan = read_plan(Path("farm.plan"))
    plan.mission[3].item.x          # 1e-7 degrees, from the text without ever being a float

`tools/plan` is the command line of it.
"""

from .bad_plan import BadPlan
from .files import read_plan, write_plan
from .plan import Home, Item, Plan, Step

__all__ = ["BadPlan", "Home", "Item", "Plan", "Step", "read_plan", "write_plan"]
