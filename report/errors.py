"""The one exception a user of this package is meant to see."""


class ReportError(Exception):
    """Says what was wrong, with which value, and what would be right, in one line."""

    def __init__(self, message: str, status: int = 1) -> None:
        super().__init__(message)
        self.status = status
