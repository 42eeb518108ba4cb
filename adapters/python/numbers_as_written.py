"""The numbers of a scene: bare JSON numbers, and exact ones in strings.

Every one is given as the binary64 number nearest to what is written.
"""

import re
from fractions import Fraction

#: No number is longer, as in carom.
MAX_LENGTH = 16_384

#: A power beyond which no text of that length is a binary64 number other than zero.
MAX_POWER = 4 * MAX_LENGTH + 2_000

FRACTION = re.compile(r"([+-]?)([0-9]+)/([0-9]+)", re.ASCII)
DECIMAL = re.compile(r"([+-]?)([0-9]*)(?:\.([0-9]*))?(?:[eE]([+-]?[0-9]+))?", re.ASCII)
HEXADECIMAL = re.compile(
    r"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?[0-9]+))?", re.ASCII
)


class NotANumber(ValueError):
    """What is written is no number, or none of binary64."""


def nearest(value):
    """The binary64 number nearest to a number of a scene, as JSON has it."""
    if isinstance(value, bool) or not isinstance(value, (int, float, str)):
        raise NotANumber(f"expected a number, found {value!r:.60}")
    if isinstance(value, float):
        return finite(value)
    try:
        return finite(float(exactly(value) if isinstance(value, str) else value))
    except OverflowError:
        raise NotANumber(f"beyond binary64: {value!r:.60}") from None


def finite(value):
    """The number, unless its text was beyond binary64."""
    if value - value != 0:
        raise NotANumber("beyond binary64")
    return value


def exactly(text):
    """The number that a string holds, as a fraction."""
    if len(text) > MAX_LENGTH:
        raise NotANumber(f"longer than {MAX_LENGTH} characters")
    if found := FRACTION.fullmatch(text):
        sign, over, under = found.groups()
        if whole(under, 10) == 0:
            raise NotANumber(f"the denominator is zero: {text!r:.60}")
        return signed(sign, Fraction(whole(over, 10), whole(under, 10)))
    if found := HEXADECIMAL.fullmatch(text):
        return positional(text, found, radix=16, base=2, step=4)
    if found := DECIMAL.fullmatch(text):
        return positional(text, found, radix=10, base=10, step=1)
    raise malformed(text)


def positional(text, found, radix, base, step):
    """A decimal or hexadecimal number; each digit after the point counts `step` powers."""
    sign, before, after, power = found.groups(default="")
    if not before + after:
        raise malformed(text)
    digits = whole(before + after, radix)
    power = whole_signed(power) - step * len(after)
    if digits == 0:
        return Fraction(0)
    if abs(power) > MAX_POWER:
        raise NotANumber(f"beyond binary64: {text!r:.60}")
    return signed(sign, digits * Fraction(base) ** power)


def whole(digits, radix):
    """An integer; in pieces, for Python refuses long decimal ones."""
    value = 0
    for start in range(0, len(digits), 1000):
        piece = digits[start : start + 1000]
        value = value * radix ** len(piece) + int(piece, radix)
    return value


def whole_signed(text):
    """An integer with a sign, or zero for an empty text."""
    digits = text.lstrip("+-")
    value = whole(digits, 10) if digits else 0
    return -value if text.startswith("-") else value


def signed(sign, value):
    """The number with its sign."""
    return -value if sign == "-" else value


def malformed(text):
    """The error of a text that is no number."""
    return NotANumber(f"not a number: {text!r:.60}")
