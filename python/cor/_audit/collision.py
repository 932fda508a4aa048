# SPDX-License-Identifier: MIT
"""Measures collisions that a simulator computes step by step. Programs that run inside a simulator also import this
file, so it imports only the standard library."""

import math
from typing import Callable, Tuple

SMALL = 100  # the deck's time step divided by the small step of the second measurement
PHASES = 4  # start phases within a time step; a measured eps is the mean over them
FEW, MOST = 2000, 2_000_000  # least and largest number of steps of a collision


class Failed(Exception):
    """A collision or a program that did not end."""


def eps_of(advance: Callable[[int], Tuple[float, float]], speed: float, touch: float) -> Tuple[float, int]:
    """Returns eps and the number of steps until the bodies have parted. advance: makes steps; returns the relative
    velocity, above 0 if the bodies part, and the distance between their centres. touch: this distance at contact."""
    steps, chunk, begun, turned, before = 0, 4, 0, 0, -speed
    while steps < MOST:
        velocity, distance = advance(chunk)
        steps += chunk
        if not math.isfinite(velocity):
            raise Failed("the velocity is not finite")
        if distance < 0 or distance < touch / 2 and not begun:
            raise Failed("the bodies pass through each other")
        begun = begun or (abs(velocity + speed) > 1e-7 * speed) * steps
        turned = turned or (velocity >= 0) * steps
        if begun and distance >= touch and abs(velocity - before) < 1e-8 * speed:
            return max(velocity / speed, 0.0), steps
        still = distance < touch and abs(velocity) < 1e-6 * speed and steps > 50 * begun
        if begun and (still or steps > 100 * turned > 0):
            return 0.0, steps  # the bodies stick, or part too slowly to be detected
        chunk, before = max(4, steps // 4), velocity
    raise Failed(f"the bodies have not parted after {steps} steps")


def measured(collide: Callable[[float, float], Tuple[float, int]], dt: float, least: float) -> Tuple[float, float]:
    """Returns two values of eps: with the time step dt, averaged over the phases of a step, and with a small step.
    collide: returns eps and the number of steps for a time step and a phase between 0 and 1. least: a time in which the
    bodies cannot pass through each other; no larger time step is tried."""
    eps, small = math.nan, least
    if dt < least:
        eps, steps = collide(dt, 0.5)
        if steps < FEW:
            eps = sum(collide(dt, (k + 0.5) / PHASES)[0] for k in range(PHASES)) / PHASES
        if steps >= MOST // 8:
            return eps, eps
        small = dt / min(SMALL, MOST / 4 / steps)
    for _ in range(6):
        eps_small, steps = collide(small, 0.5)
        if steps >= FEW // 4:
            return eps, eps_small
        small /= 10
    raise Failed("no time step resolves the contact")
