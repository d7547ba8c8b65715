"""Tcl words: numbers, lists, names."""
import re
from collections.abc import Iterable


def number(value: float) -> str:
    text = f"{value:.7g}"
    return "0" if text == "-0" else text


def numbers(values: Iterable[float]) -> str:
    """A list. What is nothing beside the largest of them is the rounding of 0."""
    values = list(values)
    least = 1e-7 * max(abs(value) for value in values)
    return "{" + " ".join(number(value if abs(value) > least else 0) for value in values) + "}"


def word(text: str) -> str:
    if re.fullmatch(r"[\w./+-]+", text):
        return text
    if not re.search(r"[{}\\\n]", text):
        return "{" + text + "}"
    return re.sub(r"([^\w./+-])", r"\\\1", text)


class Names:
    """Names that grsh takes, which need no quotes, and no two alike."""

    def __init__(self) -> None:
        self.taken: set[str] = set()

    def new(self, wish: str) -> str:
        plain = re.sub(r"[^\w.-]+", "_", wish).strip("_-.") or "unnamed"
        name, count = plain, 1
        # In lower case: file systems may not tell capitals from others.
        while name.lower() in self.taken:
            count += 1
            name = f"{plain}_{count}"
        self.taken.add(name.lower())
        return name
