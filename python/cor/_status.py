# SPDX-License-Identifier: MIT
"""What cor.status has beside enums and constants."""

from ._cor import lib
from ._evaluate import string


def text(status: int) -> str:
    """One English sentence for a status, also for a number that is none (cor_status_text)."""
    return string(lib.cor_status_text(status))
