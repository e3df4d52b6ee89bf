# SPDX-License-Identifier: MIT
from __future__ import annotations


class InvalidInput(ValueError):
    """A document that breaks a rule.

    path:   the place in the document, a JSON pointer such as "/ball/at/0"; empty for the whole document
    reason: the rule, in words
    """

    def __init__(self, path: str, reason: str) -> None:
        super().__init__(path, reason)
        self.path = path
        self.reason = reason

    def __str__(self) -> str:
        return f"{self.path}: {self.reason}" if self.path else self.reason
