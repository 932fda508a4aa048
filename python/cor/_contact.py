# SPDX-License-Identifier: MIT
"""What the class of contacts has beside the functions of contact.h."""

import math
from typing import Any, Tuple

from ._evaluate import number

ENDS = ("zero_overlap", "zero_force")
PRESSED_ENDS = ("zero_overlap", "surface")  # under a constant force


def end_name(end: str, ends: Tuple[str, ...] = ENDS) -> str:
    """An end of contact, written with a hyphen, a space or _"""
    name = str(end).replace("-", "_").replace(" ", "_")
    if name not in ends:
        raise ValueError(f"end: {end!r} is not an end of this contact; allowed: {', '.join(ends)}")
    return name


def from_restitution(cls: Any, body_1: Any, body_2: Any, eps: float, speed_m_s: float, end: str) -> Any:
    """The contact of two bodies that rebounds with eps, 0 < eps <= 1, at the impact speed, m/s, and ends at
    "zero_overlap" or "zero_force". The dissipation times of the bodies do not count: that of the pair follows from eps
    by dissipation_time_s_zero_overlap or dissipation_time_s_zero_force."""
    eps, speed_m_s = number("eps", eps), number("speed_m_s", speed_m_s)
    if not 0 < eps <= 1:
        raise ValueError(f"eps: {eps!r} is not above 0 and at most 1")
    if not 0 < speed_m_s < math.inf:
        raise ValueError(f"speed_m_s: {speed_m_s!r} is not above 0 and finite")
    pair = cls(body_1, body_2)
    time = float(getattr(pair, f"dissipation_time_s_{end_name(end)}")(speed_m_s, eps))
    bodies = [type(b)(b.young_modulus_pa, b.poisson_ratio, time, b.radius_m, b.mass_kg) for b in (body_1, body_2)]
    return cls(*bodies)
