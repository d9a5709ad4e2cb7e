"""Where the demonstration is shown: a terminal with colours and a bar, or plain lines."""

from __future__ import annotations

import sys
from typing import NamedTuple, TextIO

from rich.console import Console
from rich.markup import escape
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
from rich.table import Table


class Line(NamedTuple):
    """Something that happened, at a simulated time [s]."""

    time: float
    where: str  # "Mega -> autopilot" and so on
    text: str
    mark: str = ""  # "lost", "again" or nothing


class Row(NamedTuple):
    """One item in the comparison at the end."""

    number: int
    meant: str
    aboard: str

    @property
    def differs(self) -> bool:
        return self.meant != self.aboard


class PlainScreen:
    """Lines of text, for a log or a pipe."""

    def __init__(self, out: TextIO | None = None) -> None:
        self._out = out or sys.stdout
        self._done = -1

    def say(self, text: str) -> None:
        print(text, file=self._out, flush=True)

    def happened(self, line: Line) -> None:
        self.say(plain(line))

    def progress(self, done: int, total: int) -> None:
        if done != self._done:
            self._done = done
            self.say(f"{'':11}{done} of {total} items aboard")

    def compare(self, rows: list[Row]) -> None:
        for row in rows:
            if row.differs:
                self.say(f"  {row.number:4}  meant:  {row.meant}\n        aboard: {row.aboard}   <-- DIFFERS")
            else:
                self.say(f"  {row.number:4}  {row.meant}")

    def verdict(self, text: str, good: bool) -> None:
        self.say(text)

    def close(self) -> None:
        pass


class TerminalScreen:
    """Colours, and a bar that stays below the lines."""

    STYLES = {"lost": "red", "again": "yellow"}
    PLACES = {"Mega -> autopilot": "cyan", "autopilot -> Mega": "green", "Serial": "bold"}

    def __init__(self, console: Console | None = None) -> None:
        self._console = console or Console(highlight=False)
        self._bar = Progress(
            TextColumn("{task.description}"), BarColumn(None), MofNCompleteColumn(), console=self._console
        )
        self._task = self._bar.add_task("items aboard", total=None)
        self._bar.start()

    def say(self, text: str) -> None:
        self._console.print(escape(text))

    def happened(self, line: Line) -> None:
        style = self.STYLES.get(line.mark) or self.PLACES.get(line.where, "")
        self._console.print(f"[{style}]{escape(plain(line))}[/]" if style else escape(plain(line)), soft_wrap=True)

    def progress(self, done: int, total: int) -> None:
        self._bar.update(self._task, completed=done, total=total)

    def compare(self, rows: list[Row]) -> None:
        self._bar.stop()
        table = Table("item", "meant", "aboard")
        for row in rows:
            aboard = f"[red]DIFFERS: {escape(row.aboard)}[/]" if row.differs else f"[green]{escape(row.aboard)}[/]"
            table.add_row(str(row.number), escape(row.meant), aboard)
        self._console.print(table)

    def verdict(self, text: str, good: bool) -> None:
        self._console.print(f"[bold {'green' if good else 'red'}]{escape(text)}[/]")

    def close(self) -> None:
        self._bar.stop()


def plain(line: Line) -> str:
    mark = f"   [{line.mark}]" if line.mark else ""
    return f"{line.time:8.3f} s  {line.where:<17}  {line.text}{mark}"
