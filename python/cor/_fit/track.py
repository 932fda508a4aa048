# SPDX-License-Identifier: MIT
"""Finds the bounces in a track, the height of a ball over time."""

from typing import List, NamedTuple

import numpy as np

from .data import Floats, Ints
from .likelihood import scipy

LEAST_SAMPLES = 4  # samples of a flight
FREE_BEND, FREE_SKEW = 8, 12  # least samples for a flight's own quadratic term, and for a cubic term (drag)
ALLOWED = "a track of three bounces or more, heights measured upward, and 4 samples or more in each flight"


class Bounces(NamedTuple):
    """time_s: times of the bounces; row: the lowest sample of each bounce; gravity_m_s2: from the flights' curvature"""

    time_s: Floats
    row: Ints
    drop_height_m: float  # nan unless the track begins at rest or with an apex
    gravity_m_s2: float


def _interior(height: Floats, a: int, b: int) -> Ints:
    """Return the samples of the flight between the lowest samples a and b, without samples near the ground."""
    inside = np.arange(a + 1, b)
    low = max(height[a], height[b]) + 0.1 * (height[inside].max() - max(height[a], height[b])) if b > a + 1 else 0.0
    high = inside[height[inside] > low]
    return np.asarray(high if len(high) >= LEAST_SAMPLES else inside)


def _crossing(first: "np.poly1d", second: "np.poly1d", near: float) -> float:
    """Return the time nearest to `near` at which two flights meet, or `near` if they do not meet."""
    roots = (first - second).roots
    real = roots[np.abs(np.imag(roots)) < 1e-9 * (1 + np.abs(roots))].real
    return float(real[np.argmin(np.abs(real - near))]) if len(real) else near


def find_bounces(time: Floats, height: Floats) -> Bounces:
    """Fit a polynomial to each flight. Two flights meet at a bounce. Raise ValueError with the allowed input."""
    bend = np.diff(height, 2)
    if len(bend) < 3 * LEAST_SAMPLES:
        raise ValueError(f"{len(height)} samples of the height are too few; allowed: {ALLOWED}")
    if np.sum(bend > 0) > 0.7 * len(bend):
        raise ValueError(f"the heights increase downward, because the flights curve upward; allowed: {ALLOWED}")
    noise = 1.4826 * np.median(np.abs(bend - np.median(bend))) / np.sqrt(6)
    lowest = scipy("signal").find_peaks(-height, prominence=max(6 * noise, 0.01 * np.ptp(height)))[0]
    flights: List["np.poly1d"] = []
    bends: List[float] = []  # second derivatives
    for a, b in zip(lowest[:-1], lowest[1:]):
        inside = _interior(height, a, b)
        if len(inside) < LEAST_SAMPLES:
            break
        t, y = time[inside] - time[a], height[inside]
        if len(inside) >= FREE_BEND or not bends:
            flights.append(np.poly1d(np.polyfit(t, y, 3 if len(inside) >= FREE_SKEW else 2)))
            bends.append(float(flights[-1].deriv(2)((time[b] - time[a]) / 2)))
        else:
            bend_term = np.median(bends) / 2
            flights.append(np.poly1d([bend_term, *np.polyfit(t, y - bend_term * t * t, 1)]))
    if len(flights) < 2:
        raise ValueError(f"{len(lowest)} bounces found in {len(height)} samples; allowed: {ALLOWED}")
    lowest = lowest[: len(flights) + 1]
    meet, ground = [], []
    for k in range(1, len(flights)):
        shift = np.poly1d([1.0, time[lowest[k]] - time[lowest[k - 1]]])  # maps a time in flight k to flight k - 1
        at = _crossing(flights[k - 1](shift), flights[k], 0.0)
        meet.append(time[lowest[k]] + at)
        ground.append(float(flights[k](at)))
    floor = np.poly1d([float(np.median(ground))])
    first = time[lowest[0]] + _crossing(flights[0], floor, 0.0)
    span = time[lowest[-1]] - time[lowest[-2]]
    last = time[lowest[-2]] + _crossing(flights[-1], floor, span)
    begin = height[: max(lowest[0], 1)]
    top = int(np.argmax(begin))
    fall = float(np.mean(begin[begin >= begin[top] - 3 * noise]) - floor(0))
    after = min(top + LEAST_SAMPLES, len(begin) - 1)
    free_fall = -float(np.median(bends)) * (time[after] - time[top]) ** 2 / 2  # from rest
    still = begin[top] - begin[after] < 2 * free_fall + 4 * noise
    return Bounces(
        np.array([first, *meet, last]), lowest, fall if still and fall > 0 else np.nan, -float(np.median(bends))
    )
