"""The JSON that QGroundControl wrote before .plan, in files called .mission: a mission alone, each item's place apart.

Of version 2, and of version "1.0", whose items have their parameters by name.
"""

from __future__ import annotations

from pathlib import Path

from .located_json import Value, parse
from .plan import Plan
from .qgc_plan import UINT16, Reader

COMPLEX_CURE = (
    "a survey of an old file is not held by its items: open the file in a present QGroundControl, save it as .plan"
)


def read(file: Path, text: str, unset_as_zero: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none or says what cannot be carried exactly."""
    document = parse(file, text)
    version = document.need("version")
    if version.raw == "1.0" or version.raw == 1:
        return _FirstVersion(file, unset_as_zero).plan(document)
    if version.raw != 2:
        raise version.bad(
            "only versions 1.0 and 2 of a .mission are known: open it in QGroundControl, save it as .plan"
        )
    return _Reader(file, unset_as_zero).plan(document)


class _Reader(Reader):
    def plan(self, document: Value) -> Plan:
        self._mission_of(document)
        self._notes.add("a .mission does not say what else is flown with it: its fence and rally points are not in it")
        self._plan.notes = self._notes.texts()
        return self._plan

    @staticmethod
    def _params(value: Value, name: str) -> Value:
        params = value.need("params").called(f"{name}: params")
        place = value.need("coordinate").called(f"{name}: coordinate")
        if len(params.array()) != 4 or len(place.array()) != 3:
            raise params.bad(f"{name}: params must be 4 numbers, and coordinate 3")
        return Value(params.file, params.line, [*params.raw, *place.raw], params.name)


class _FirstVersion(_Reader):
    def plan(self, document: Value) -> Plan:
        patterns = document.get("complexItems")
        if patterns is not None and patterns.array():
            raise patterns.bad(COMPLEX_CURE)
        return super().plan(document)

    def _home(self, value: Value | None) -> None:
        """Home is an item there."""
        if value is not None and isinstance(value.raw, dict):
            value = value.need("coordinate")
        super()._home(value)

    def _any(self, value: Value) -> None:
        kind = value.need("type")
        if kind.text() != "missionItem":
            raise kind.bad(f"{value.name}: {COMPLEX_CURE}")
        self._simple(value, "")

    @staticmethod
    def _jump_id(value: Value) -> int | None:
        number = value.get("id")
        return None if number is None else number.whole(UINT16)

    @staticmethod
    def _params(value: Value, name: str) -> Value:
        place = value.need("coordinate").called(f"{name}: coordinate")
        if len(place.array()) != 3:
            raise place.bad(f"{name}: coordinate must be 3 numbers")
        params = [value.need(f"param{i}") for i in (1, 2, 3, 4)]
        return Value(value.file, value.line, [*params, *place.raw], f"{name}: params")
