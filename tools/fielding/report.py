"""What came of the trials, as Markdown to keep."""

from __future__ import annotations

from collections.abc import Sequence

from .trials import Outcome

KINDS = ("uploads", "random items", "examples", "flights")


def report(day: str, outcomes: Sequence[Outcome]) -> str:
    """Counts by kind, every contradiction with its seed and frames, and the line for docs/autopilots.md."""
    versions = list(dict.fromkeys(one.version for one in outcomes if one.version)) or ["nothing was flown"]
    clock = "; ".join(dict.fromkeys(one.clock for one in outcomes if one.clock))
    trials = [one for one in outcomes if not one.broke]
    against = [one for one in trials if one.contradictions]
    broken = [one for one in outcomes if one.broke]
    counts = f"{len(trials)} trials, {len(against)} with a contradiction; {len(broken)} came to nothing."
    lines = [f"# tools/field: {', '.join(versions)}", "", f"{counts} Clock: {clock}.", "",
             "| | trials | with a contradiction | simulated |", "|---|---|---|---|"]  # fmt: skip
    for kind in KINDS:
        if own := [one for one in trials if one.kind == kind]:
            minutes = sum(one.simulated_s for one in own) / 60
            wrong = sum(bool(one.contradictions) for one in own)
            lines.append(f"| {kind} | {len(own)} | {wrong} | {minutes:.0f} min |")
    lines += ["", "## Contradictions", ""]
    told = ((f"{one.vehicle}: {one.name}, seed {one.seed}", one) for one in against)
    lines += [f"- {name}: {words} (`{one.frames}`)" for name, one in told for words in one.contradictions] or ["None."]
    if broken:
        lines += ["", "## Trials that came to nothing", ""]
        lines += [f"- {one.vehicle}: {one.name}, seed {one.seed}: {one.broke}" for one in broken]
    if differ := [(one, words) for one in trials for words in one.fakes_differ]:
        lines += ["", "## What the fakes do otherwise", ""]
        lines += [f"- {one.vehicle}, seed {one.seed}: {words}" for one, words in differ]
    lines += ["", "## Every trial", "", "| | trial | seed | ended | s | notes |", "|---|---|---|---|---|---|"]
    for one in trials:
        notes = f"{len(one.notes)} items" if one.kind == "random items" else "; ".join(one.notes).replace("|", "/")
        lines.append(f"| {one.vehicle} | {one.name} | {one.seed} | {one.status} | {one.simulated_s:.0f} | {notes} |")
    lines += ["", "For the table of docs/autopilots.md:", ""]
    lines += [line_of_autopilots(one, day, outcomes) for one in versions]
    return "\n".join([*lines, ""])


def line_of_autopilots(version: str, day: str, outcomes: Sequence[Outcome]) -> str:
    trials = [one for one in outcomes if one.version == version and not one.broke]
    counts = ", ".join(f"{kind} {number}" for kind in KINDS if (number := sum(one.kind == kind for one in trials)))
    against = sum(bool(one.contradictions) for one in trials)
    return f"| {version} | {day} | {counts} | {against or 'none'} |"
