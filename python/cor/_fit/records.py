# SPDX-License-Identifier: MIT
"""Reads measured bounces from a csv file, a file object, a data frame of pandas or arrays."""

from typing import Any

from .data import Data, Form


def read(source: Any, form: Form = Form()) -> Data:
    """Return the data of a path ("-": standard input), an open file, a data frame, or a dict or list of arrays."""
    raise NotImplementedError
