# SPDX-License-Identifier: MIT
"""The functions of cor.status."""

from ._cor import lib
from ._evaluate import string


def text(status: int) -> str:
    """Returns an English sentence for a status, also for a number that is not a status (cor_status_text)."""
    return string(lib.cor_status_text(status))
