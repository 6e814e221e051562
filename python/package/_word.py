# SPDX-License-Identifier: MIT
"""The class of augicp's enumerations."""
import enum


class Word(str, enum.Enum):
    """One of some words. It equals its word, and str() gives it."""

    def __str__(self) -> str:
        return str(self.value)
