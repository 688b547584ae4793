"""Numbers of pages as text that can be checked on another machine.

Processors differ in the last digits of a result, so that a number beside the
edge of its rounding may be printed in two ways. Such numbers, and seconds, carry
in a rendered page what else may stand in their place, between characters of
Unicode's private use; `plain` takes these out and `matches` reads them.
"""

import math
import re

BEGIN, OR, END, ANY = "\ue000", "\ue001", "\ue002", "\ue003"
MARK = re.compile(f"{BEGIN}([^{END}]*){END}")

PROCESSORS_DIFFER_BY = 1e-6  # relative


def with_alternatives(value, to_text, uncertainty):
    """`to_text(value)`, with what it would be a little below and above."""
    if value is None:
        return ""
    texts = [to_text(value * (1 + sign * uncertainty)) for sign in (0, -1, 1)]
    texts = [re.sub(r"^-(?=0\.?0*$)", "", text) for text in texts]  # no -0.0
    others = sorted(set(texts) - {texts[0]})
    return BEGIN + OR.join([texts[0]] + others) + END if others else texts[0]


def decimals(value, digits=0, uncertainty=PROCESSORS_DIFFER_BY):
    """1302.445 -> 1302.45 with two digits after the point."""
    return with_alternatives(value, lambda v: f"{v:.{digits}f}", uncertainty)


def percent(value, digits=1, uncertainty=PROCESSORS_DIFFER_BY):
    """0.0223 -> 2.2; the sign stands in the text or the head of the table."""
    return None if value is None else decimals(100 * value, digits, uncertainty)


def change(value, digits=1, uncertainty=PROCESSORS_DIFFER_BY):
    """A relative change in per cent with its sign: 0.014 -> +1.4."""
    return with_alternatives(value, lambda v: f"{100 * v:+.{digits}f}", uncertainty)


def significant(value, digits=3, uncertainty=PROCESSORS_DIFFER_BY):
    """1302.445 -> 1.3e+03 with two digits, 1302 with four; zeros at the end stay."""
    def to_text(number):
        text = f"{number:#.{digits}g}".rstrip(".")
        return re.sub(r"e([+-])0?(\d)", lambda m: f"e{m[1].strip('+')}{m[2]}", text)
    return with_alternatives(value, to_text, uncertainty)


def power(value, digits=0, uncertainty=PROCESSORS_DIFFER_BY):
    """9.6e-4, for errors."""
    def to_text(number):
        mantissa, exponent = f"{number:.{digits}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    return with_alternatives(value, to_text, uncertainty)


def scale(factor):
    """A filter that shows a value in a unit of `1 / factor`."""
    return lambda value, digits=1, uncertainty=PROCESSORS_DIFFER_BY: (
        None if value is None else decimals(factor * value, digits, uncertainty))


def seconds(value, digits=2):
    """Seconds differ with every run and are never checked."""
    return "" if value is None else f"{BEGIN}{value:.{digits}f}{OR}{ANY}{END}"


def free_seconds(text):
    """Printed text whose seconds are free: the last column of the table of
    cycles and what is followed by the unit."""
    def free(match):
        return match[1] + BEGIN + match[2] + OR + ANY + END
    text = re.sub(r"(?m)^( +\d.* )(\d+\.\d+)$", free, text)
    return re.sub(r"()(\d+(?:\.\d+)?)(?= (?:ms|s|min)\b)", free, text)


def decades(value):
    """A relative deviation by its size, 2e-4; < 1e-11 where it is round-off."""
    return "< 1e-11" if abs(value) < 1e-11 else power(value)


def plain(text):
    """The rendered text as it is written to a file."""
    return MARK.sub(lambda match: match[1].split(OR)[0], text)


def matches(expected, actual):
    """Whether a text is what was rendered, or one of the alternatives."""
    pattern, at = "", 0
    for mark in MARK.finditer(expected):
        pattern += re.escape(expected[at:mark.start()])
        pattern += "(?:" + "|".join(
            r"\d+(?:\.\d+)?" if text == ANY else re.escape(text)
            for text in mark[1].split(OR)) + ")"
        at = mark.end()
    return re.fullmatch(pattern + re.escape(expected[at:]), actual) is not None


def root_mean_square(values):
    values = list(values)
    return math.sqrt(sum(value**2 for value in values) / len(values))


FILTERS = {
    "decimals": decimals, "percent": percent, "change": change,
    "significant": significant, "power": power, "seconds": seconds, "decades": decades,
    "log2": math.log2, "rms": root_mean_square,
    "us": scale(1e6), "ms": scale(1e3), "mm": scale(1e3), "um": scale(1e6), "mN": scale(1e3),
}
