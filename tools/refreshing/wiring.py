"""How a board is joined to a Pixhawk's TELEM connector: docs/wiring.svg.

One drawing for each of three boards, one below the other, so that a phone shows them without zooming.
"""

from __future__ import annotations

from dataclasses import dataclass
from xml.sax.saxutils import escape


@dataclass(frozen=True)
class Board:
    name: str
    level: str
    rx: str  # its pins, as they are printed on the board
    tx: str

    @property
    def needs_divider(self) -> bool:
        """The Pixhawk's inputs are made for 3.3 V."""
        return self.level == "5 V"


BOARDS = (
    Board("Mega 2560", "5 V", "19 RX1", "18 TX1"),
    Board("Nano, Uno", "5 V", "0 RX", "1 TX"),
    Board("ESP32", "3.3 V", "GPIO16", "GPIO17"),
)
# Pins of a TELEM connector: those that are joined, from above, and those that stay open.
TELEM = {"TX": 2, "RX": 3, "GND": 6}
OPEN = {"5 V": 1, "CTS": 4, "RTS": 5}

WIDTH, PANEL = 390, 214
LEFT, RIGHT = (10, 118), (272, 380)  # the boxes' edges
ROWS = {"TX": 74, "RX": 118, "GND": 172}  # by the Pixhawk's pin, below a panel's top
DIVIDER_X = 222
COLOURS = {"TX": "#1b7f4b", "RX": "#1f5fa8", "GND": "#222222"}
LETTER = 0.6  # width of a letter, in shares of its size


def text(x: float, y: float, words: str, size: int = 15, anchor: str = "start", colour: str = "#222222",
         weight: str = "normal") -> str:  # fmt: skip
    return (f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}" fill="{colour}" '
            f'font-weight="{weight}">{escape(words)}</text>')  # fmt: skip


def wire(points: str, colour: str) -> str:
    return f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="3"/>'


def box(left: float, top: float, width: float, height: float, fill: str) -> str:
    return (f'<rect x="{left:g}" y="{top:g}" width="{width:g}" height="{height:g}" rx="4" fill="{fill}" '
            f'stroke="#222222" stroke-width="1.5"/>')  # fmt: skip


def arrow(x: float, y: float, length: float, colour: str) -> str:
    """With its tip at x; a positive length points to the left."""
    return f'<polygon points="{x:g},{y:g} {x + length:g},{y - 6:g} {x + length:g},{y + 6:g}" fill="{colour}"/>'


def panel(board: Board, top: float) -> list[str]:
    drawn = [
        text(LEFT[0], top + 26, f"{board.name} ({board.level})", 18, weight="bold"),
        text(RIGHT[1], top + 26, "Pixhawk TELEM", 18, "end", weight="bold"),
        box(LEFT[0], top + 40, LEFT[1] - LEFT[0], 156, "#e3f0fa"),
        box(RIGHT[0], top + 40, RIGHT[1] - RIGHT[0], 156, "#f3ecdc"),
    ]
    own = {"TX": board.rx, "RX": board.tx, "GND": "GND"}
    for name, row in ROWS.items():
        y = top + row
        drawn += [
            wire(f"{LEFT[1]},{y:g} {RIGHT[0]},{y:g}", COLOURS[name]),
            text(LEFT[1] - 8, y + 5, own[name], 16, "end", COLOURS[name], "bold"),
            text(RIGHT[0] + 8, y + 5, f"{TELEM[name]}  {name}", 16, "start", COLOURS[name], "bold"),
        ]
    drawn += [arrow(LEFT[1] + 2, top + ROWS["TX"], 12, COLOURS["TX"]),
              arrow(RIGHT[0] - 2, top + ROWS["RX"], -12, COLOURS["RX"])]  # fmt: skip
    if board.needs_divider:
        from_y, to_y = top + ROWS["RX"], top + ROWS["GND"]
        drawn += [
            wire(f"{DIVIDER_X},{from_y:g} {DIVIDER_X},{to_y:g}", COLOURS["RX"]),
            box(150, from_y - 9, 44, 18, "#ffffff"),
            text(172, from_y + 5, "1 kΩ", 14, "middle"),
            box(DIVIDER_X - 9, from_y + 12, 18, 34, "#ffffff"),
            text(DIVIDER_X - 14, from_y + 34, "2 kΩ", 14, "end"),
        ]
    return drawn


def drawing() -> str:
    height = PANEL * len(BOARDS) + 50
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" width="{WIDTH}" height="{height}" '
        'font-family="Helvetica, Arial, sans-serif">',
        "<title>A board's serial port joined to a Pixhawk's TELEM connector</title>",
        f'<rect width="{WIDTH}" height="{height}" fill="#ffffff"/>',
    ]
    for number, board in enumerate(BOARDS):
        lines += panel(board, PANEL * number)
    left_open = ", ".join(f"{number} ({name})" for name, number in OPEN.items())
    below = PANEL * len(BOARDS)
    lines += [
        text(LEFT[0], below + 18, f"Left open: {left_open}."),
        text(LEFT[0], below + 38, "Power each side from its own supply."),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"
