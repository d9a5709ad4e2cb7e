"""Tables of figures that tests have measured, at the end of a test run.

    def test_something(record_property):
        record_property("table", ["title", [["column", "another"], ["1", "2"]]])

The first row is the head. test/conftest.py registers this module with pytest.
"""

from __future__ import annotations

PROPERTY = "table"


def aligned(rows: list[list[str]]) -> list[str]:
    """The rows as lines, each column as wide as it needs; numbers to the right."""
    widths = [max(len(row[column]) for row in rows) for column in range(len(rows[0]))]
    return [
        " | ".join(
            cell.rjust(width) if column and rows[1:] else cell.ljust(width)
            for column, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
    ]


def pytest_terminal_summary(terminalreporter) -> None:
    for reports in terminalreporter.stats.values():
        for report in reports:
            if getattr(report, "when", None) != "call":
                continue
            for name, value in report.user_properties:
                if name == PROPERTY:
                    title, rows = value
                    terminalreporter.section(title)
                    for line in aligned(rows):
                        terminalreporter.write_line(line)
