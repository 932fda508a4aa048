# SPDX-License-Identifier: MIT
"""Defines measured bounces, which the reader (records) passes to the fit: in SI units and in the order of the file."""

from dataclasses import dataclass, replace
from typing import Optional, Tuple, Union

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]
Ints = npt.NDArray[np.int64]

GRAVITY_M_S2 = 9.80665  # standard gravity
MAX_BEYOND = 5  # eps of a point may be below 0 or above 1 by this number of sigmas
MAX_FLIGHT_RATIO = 1.2  # noise of a flight or a rebound may raise eps up to this value


class DataError(ValueError):
    """Raised for data that cannot be read. The text names line and column, the allowed values and an example."""


@dataclass(frozen=True)
class Points:
    """Impacts with measured speed and eps, or with measured speeds before and after."""

    speed_m_s: Floats
    eps: Floats
    sigma: Optional[Floats]  # standard deviation of eps
    line: Ints
    ball: Ints  # index in Data.balls


@dataclass(frozen=True)
class Heights:
    """Drops from a height, each with the height of its first rebound. The speeds depend on the drag, too."""

    drop_m: Floats
    rebound_m: Floats
    drop_sigma_m: Optional[Floats]  # standard deviations
    rebound_sigma_m: Optional[Floats]
    line: Ints
    ball: Ints


@dataclass(frozen=True)
class Times:
    """Drops with measured times of bounces. Drop k has the elements start[k] to start[k + 1] - 1 of time_s and line."""

    time_s: Floats  # ascending within a drop, any origin
    line: Ints
    start: Ints
    height_m: Floats  # for each drop, the height above the ground from which the ball fell; nan: unknown
    ball: Ints  # for each drop: index in Data.balls


@dataclass(frozen=True)
class Apexes:
    """Drops with heights of apexes. Element start[k] of height_m is the drop height of drop k; rebounds follow."""

    height_m: Floats
    sigma_m: Optional[Floats]
    line: Ints
    start: Ints
    ball: Ints  # for each drop: index in Data.balls


@dataclass(frozen=True)
class Data:
    """A file or arrays. balls is empty without a column ball; then every ball index is 0."""

    name: str  # name in messages: a path, "standard input", "the data frame"
    record: Union[Points, Heights, Times, Apexes]
    balls: Tuple[str, ...] = ()
    unused: Tuple[str, ...] = ()  # names of the columns that are not read
    remarks: Tuple[str, ...] = ()  # sentences about the reading, such as the number of bounces in a track
    row_word: str = "line"  # "line": counted from 1 with the header; "row": element of arrays, from 0

    def of_ball(self, ball: int) -> "Data":
        """Return the data of one ball, balls[ball]."""
        record, mine = self.record, self.record.ball == ball
        of_drops = ("ball", "height_m") if isinstance(record, Times) else ("ball",)
        rows, changed = mine, {}
        if isinstance(record, (Times, Apexes)):
            counts = np.diff(record.start)
            rows, changed = np.repeat(mine, counts), {"start": np.append(0, np.cumsum(counts[mine]))}
        for name, value in vars(record).items():
            if name != "start" and value is not None:
                changed[name] = value[mine if name in of_drops else rows]
        return replace(self, record=replace(record, **changed))


@dataclass(frozen=True)
class Form:
    """The format of the source."""

    unit: Optional[str] = None  # unit of speeds, heights or times whose columns name no unit: "cm/s", "cm", "ms"
    separator: Optional[str] = None  # ",", ";" or "\t"; None: the most frequent one in the row of names
    decimal_comma: bool = False
    drop_height_m: Optional[float] = None  # of every drop
