"""What goes wrong, and what has no match."""
import sys


class ExportError(Exception):
    """Ends the export before anything is written."""


class Warnings:
    """Tells each thing once."""

    def __init__(self) -> None:
        self.told: set[str] = set()

    def warn(self, thing: str, what: str) -> None:
        """thing: e.g. 'object "Cube"'; what: what was done instead."""
        message = f"{thing}: {what}"
        if message not in self.told:
            self.told.add(message)
            print(f"export_gr: warning: {message}", file=sys.stderr)
