"""What uploads came to on lines that lose frames, in two tables at the end of a test run.

    note_survival(record_property, "one frame lost", "PX4", "ByAnswer", survived=True)
    note_end(record_property, 20, "PX4", "InDoubt", status="Accepted", is_aboard=True)

Each counts one upload. test/conftest.py registers this module with pytest.
"""

from __future__ import annotations

from collections import defaultdict

from tables import aligned

SURVIVAL, END = "survival", "end of an upload"


def note_survival(record_property, what: str, personality: str, proof: str, survived: bool) -> None:
    """An upload during which this was lost; whether it ended Accepted with the plan aboard."""
    record_property(SURVIVAL, [what, personality, proof, survived])


def note_end(record_property, percent: int, personality: str, proof: str, status: str, is_aboard: bool) -> None:
    """An upload on a line that loses so many percent of all frames."""
    record_property(END, [percent, personality, proof, status, is_aboard])


def survivals(noted: list) -> list[list[str]]:
    """Rows: what was lost, by whom; survived of tried for each proof."""
    proofs = sorted({proof for _, _, proof, _ in noted})
    found: dict[tuple[str, str], dict[str, list[bool]]] = defaultdict(lambda: defaultdict(list))
    for what, personality, proof, survived in noted:
        found[what, personality][proof].append(survived)
    rows = [["lost", "autopilot", *(f"survived, {proof}" for proof in proofs)]]
    for (what, personality), by_proof in sorted(found.items()):
        cells = [f"{sum(by_proof[proof])} of {len(by_proof[proof])}" if by_proof[proof] else "-" for proof in proofs]
        rows.append([what, personality, *cells])
    return rows


def ends(noted: list) -> list[list[str]]:
    """Rows: how many of the uploads on such a line ended how, and how many said Accepted untruly."""
    found: dict[tuple[int, str, str], list[tuple[str, bool]]] = defaultdict(list)
    for percent, personality, proof, status, is_aboard in noted:
        found[percent, personality, proof].append((status, is_aboard))
    rows = [["frames lost", "autopilot", "proof", "uploads", "Accepted", "Unconfirmed", "failed", "false Accepted"]]
    for (percent, personality, proof), outcomes in sorted(found.items()):
        accepted = [is_aboard for status, is_aboard in outcomes if status == "Accepted"]
        unconfirmed = sum(status == "Unconfirmed" for status, _ in outcomes)
        counts = [len(outcomes), sum(accepted), unconfirmed, len(outcomes) - len(accepted) - unconfirmed,
                  len(accepted) - sum(accepted)]  # fmt: skip
        rows.append([f"{percent:2} %", personality, proof, *map(str, counts)])
    return rows


def pytest_terminal_summary(terminalreporter) -> None:
    noted: dict[str, list] = {SURVIVAL: [], END: []}
    for kind in ("passed", "failed"):
        for report in terminalreporter.stats.get(kind, []):
            if getattr(report, "when", None) != "call":
                continue
            for name, value in report.user_properties:
                if name in noted:
                    noted[name].append(value)
    for title, rows, values in (
        ("frames of an upload lost in turn", survivals, noted[SURVIVAL]),
        ("uploads on a line that loses frames at random", ends, noted[END]),
    ):
        if values:
            terminalreporter.section(title)
            for line in aligned(rows(values)):
                terminalreporter.write_line(line)
