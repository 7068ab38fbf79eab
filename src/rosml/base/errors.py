"""Errors that a user can fix."""

from __future__ import annotations


class RosmlError(Exception):
    """A failure with its remedy, which is empty if the message says it already. Commands print both, without a traceback.

    The exit code is 1 if the work failed, 2 if the input was wrong.
    """

    def __init__(self, message: str, remedy: str = "", exit_code: int = 1) -> None:
        super().__init__(message)
        self.message = message
        self.remedy = remedy
        self.exit_code = exit_code
