"""A plan, and what a part of it is replaced by."""

from __future__ import annotations

from plans import waypoint

OLD = [waypoint(473977420 + 100 * n, 85455970, 20.0 + n) for n in range(8)]
NEW = [one._replace(y=85465970) for one in OLD]
