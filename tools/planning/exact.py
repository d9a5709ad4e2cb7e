"""Numbers from text to what goes over the wire, and back, rounded once and never through a float of another size.

A coordinate is 1e-7 degree in an integer; a parameter is a 32-bit float.
"""

from __future__ import annotations

import math
import struct
from decimal import Decimal, InvalidOperation
from fractions import Fraction

_FLOAT = struct.Struct("<f")
_BITS = struct.Struct("<I")
LARGEST_FLOAT = Fraction(2**24 - 1) * 2**104
# Beyond these powers of ten a number is too large for anything here, or 0 for everything.
_HIGHEST, _LOWEST = 40, -60

# The longest text of a number that is read [characters]: what people and programs write has up to 25, and the time to
# read one grows with the square of its digits.
MOST_CHARACTERS = 100

E7 = 10**7
INT32 = range(-(2**31), 2**31)


class DoesNotFit(ValueError):
    """A number that its place on the wire cannot hold; the text says which and why.

    `parameter`: the one of an item's seven parameters that it is about, if it is about one.
    """

    def __init__(self, text: str, parameter: int | None = None) -> None:
        super().__init__(text)
        self.parameter = parameter


def decimal_of(text: str) -> Decimal:
    """A number as it stands in a file; a ValueError, with the reason, if it is none. "NaN" is a number, an infinite
    one is not."""
    if len(text) > MOST_CHARACTERS:
        raise ValueError(f"it has {len(text):,} characters, and no number of more than {MOST_CHARACTERS} is read")
    try:
        number = Decimal(text)
    except InvalidOperation:
        raise ValueError(f"{text!r} is not a number") from None
    if number.is_infinite() or number.is_snan() or "_" in text or not text.isascii():
        raise ValueError(f"{text!r} is not a number")
    return number


def fraction(number: Decimal) -> Fraction:
    """The same number; one too small to matter is 0."""
    if number and number.adjusted() > _HIGHEST:
        raise DoesNotFit(f"{number} is too large")
    return Fraction(number) if number and number.adjusted() >= _LOWEST else Fraction(0)


def e7_of(degrees: Decimal) -> int:
    """The nearest 1e-7 degree, a tie to the even one."""
    e7 = round(fraction(degrees) * E7)
    if e7 not in INT32:
        raise DoesNotFit(f"{degrees} degrees is more than a coordinate can be")
    return e7


def int32_of(number: Decimal) -> int:
    """A whole number, as it is."""
    exact = fraction(number)
    if exact.denominator != 1:
        raise DoesNotFit(f"{number} must be a whole number: MISSION_ITEM_INT carries it as one")
    if not INT32[0] <= exact <= INT32[-1]:  # "in" would count a range through for a Fraction
        raise DoesNotFit(f"{number} is more than the 32 bits that MISSION_ITEM_INT has for it")
    return int(exact)


def is_whole(number: Decimal) -> bool:
    return number == number.to_integral_value()


def float_bits(value: float) -> int:
    """The bits of a 32-bit float."""
    return _BITS.unpack(_FLOAT.pack(value))[0]


def from_bits(bits: int) -> float:
    return _FLOAT.unpack(_BITS.pack(bits))[0]


def float32_of(number: Decimal) -> float:
    """The nearest 32-bit float, a tie to the even one; NaN for NaN."""
    if number.is_nan():
        return math.nan
    exact = abs(fraction(number))
    if exact >= LARGEST_FLOAT + Fraction(2**103):
        raise DoesNotFit(f"{number} is more than a 32-bit float can hold")
    # A float of 64 bits is right to within one step of the 32-bit one: look at its neighbours too.
    near = float_bits(float(min(exact, LARGEST_FLOAT)))
    candidates = [bits for bits in (near - 1, near, near + 1) if 0 <= bits < 0x7F800000]
    best = from_bits(min(candidates, key=lambda bits: (abs(Fraction(from_bits(bits)) - exact), bits & 1)))
    return -best if number.is_signed() else best


def decimal_text(value: float) -> str:
    """The shortest plain decimal that is read as this 32-bit float by each reader, even by one that rounds twice."""
    if math.isnan(value):
        return "NaN"
    if math.isinf(value):
        return "infinite"
    if value == 0:
        return "-0" if math.copysign(1, value) < 0 else "0"
    exact = abs(Fraction(value))
    bits = float_bits(abs(value))
    step = min(exact - Fraction(from_bits(bits - 1)), Fraction(from_bits(min(bits + 1, 0x7F7FFFFF))) - exact or exact)
    for digits in range(1, 18):
        text = f"{abs(value):.{digits}g}"
        if abs(Fraction(text) - exact) * 2 <= step * (1 - Fraction(1, 2**20)):
            break
    plain = f"{Decimal(text):f}"
    if "." in plain:
        plain = plain.rstrip("0").rstrip(".")
    return f"-{plain}" if value < 0 else plain


def degrees_text(e7: int, decimals: int = 1) -> str:
    """1e-7 degrees as degrees: all that count of the seven decimals, and at least so many."""
    whole, rest = divmod(abs(e7), E7)
    shown = f"{rest:07}".rstrip("0").ljust(decimals, "0")
    return f"{'-' if e7 < 0 else ''}{whole}.{shown}"
