"""What came of it, as text to paste."""

from __future__ import annotations

from collections.abc import Sequence
from statistics import median

from .scenarios import Result


def report(about: str, ports: str, results: Sequence[Result]) -> str:
    """A table in Markdown, with the board and the times of its port above it, and its line for docs/boards.md below."""
    wrong = [result for result in results if not result.is_right]
    lines = [
        f"tools/bench: {len(results) - len(wrong)} of {len(results)} as expected",
        "",
        f"- board: {about}",
        f"- ports: {ports}",
        f"- {timing(results)}",
        f"- {counted(results)}",
        "",
        "| | autopilot | status | s | frames struck | |",
        "|---|---|---|---|---|---|",
        *(
            f"| {one.scenario} | {one.autopilot} | `{one.status}` | {one.seconds:.1f} | {one.struck} | "
            f"{'; '.join(one.wrong) or 'right'} |"
            for one in results
        ),
        "",
        "for the table of docs/boards.md; write the board's name, the day and who you are into it:",
        line_of_boards(about, results),
    ]
    return "\n".join(lines)


def line_of_boards(about: str, results: Sequence[Result]) -> str:
    beside = ", ".join(dict.fromkeys(f"simulated {one.autopilot}" for one in results))
    right = sum(one.is_right for one in results)
    return f"| {about} | {beside} | {right} of {len(results)} as expected; {timing(results)} | |"


def timing(results: Sequence[Result]) -> str:
    """Of the uploads on a good line: from the moment when a request is sent to the last byte of its item."""
    clean = [ms for one in results if one.is_on_good_line for ms in one.round_trips_ms]
    if not clean:
        return "no request was answered on a good line"
    return (
        f"request to item: {median(clean):.1f} ms in the median, {max(clean):.1f} ms at the most, of {len(clean)} "
        "(the adapter's latency included)"
    )


def counted(results: Sequence[Result]) -> str:
    """What the board says of its line, where nothing was lost by the tool."""
    clean = [one.counters for one in results if one.is_on_good_line]
    skipped, bad, lost = (sum(one.get(key, 0) for one in clean) for key in ("skipped", "bad", "lost"))
    total = sum(one.get("bytes", 0) for one in clean)
    slowest = max((one.get("loop", 0) for one in clean), default=0)
    return (
        f"on a good line the board has received {total:,} bytes, of them {skipped} outside frames, {bad} frames with a "
        f"wrong checksum, {lost} frames missing; its longest loop() took {slowest / 1000:.1f} ms"
    )
