# SPDX-License-Identifier: MIT
"""Computes volumes of bodies other than spheres, and how easily an impact off the centre turns them."""

import math
from functools import lru_cache
from typing import Optional, Tuple

import numpy as np

COLUMNS, DIRECTIONS, MOST = 120, 40000, 200  # columns per side of the grid; number of normals; most spheres of a body
Spheres = Tuple[Tuple[float, ...], ...]  # x, y, z, radius


@lru_cache(64)
def clump(spheres: Spheres, masses: Optional[Tuple[float, ...]] = None) -> Tuple[float, Tuple[float, float]]:
    """Returns the volume of the union of spheres, within about 1e-4, and the levers of contacts with a particle and
    with a plane. lever: the largest m (r x n) I^-1 (r x n) of a contact at r with the normal n. The smallest effective
    mass of one contact is m/(1 + lever). masses: of the spheres; without them the union has one density."""
    sizes = [abs(x) for sphere in spheres for x in sphere]
    least, light = (min(values, default=0.0) for values in ([s[3] for s in spheres], masses or (1.0,)))
    moderate = 1e-30 < max(sizes, default=0.0) < 1e6 * least and 1e-30 < max(masses or (1.0,)) < 1e12 * light
    if not (moderate and len(spheres) <= MOST and math.isfinite(sum(sizes) + sum(masses or ()))):
        return math.nan, (math.nan, math.nan)
    points, radii = np.array(spheres, float)[:, :3], np.array(spheres, float)[:, 3]
    points = points[:, np.ptp(points, axis=0).argsort()]  # the columns of the grid are along the longest axis
    low, high = (points - radii[:, None]).min(0), (points + radii[:, None]).max(0)
    x, y = (a + (b - a) * (np.arange(COLUMNS) + 0.5) / COLUMNS for a, b in zip(low[:2], high))
    x, y = (v.ravel() for v in np.meshgrid(x, y))
    half = radii[:, None] ** 2 - (x - points[:, :1]) ** 2 - (y - points[:, 1:2]) ** 2
    half = np.sqrt(np.maximum(half, 0))
    bottom, top = points[:, 2:] - half, points[:, 2:] + half
    order = bottom.argsort(0)
    bottom, top = (np.take_along_axis(v, order, 0) for v in (bottom, top))
    start = np.maximum(bottom, np.vstack([bottom[:1], np.maximum.accumulate(top, 0)[:-1]]))
    stop = np.maximum(top, start)
    z0, z1, z2 = (((stop**k - start**k) / k).sum(0) for k in (1, 2, 3))  # integrals of 1, z, z^2 over each column
    whole = z0.sum()
    if not whole > 0:
        return math.nan, (math.nan, math.nan)
    centre = np.array([(x * z0).sum(), (y * z0).sum(), z1.sum()]) / whole
    xz, yz = (x * z1).sum(), (y * z1).sum()
    second = np.array([[(x * x * z0).sum(), (x * y * z0).sum(), xz], [0, (y * y * z0).sum(), yz], [0, 0, z2.sum()]])
    second = (second + np.triu(second, 1).T) / whole - np.outer(centre, centre)
    volume = float(whole * np.prod((high - low)[:2]) / COLUMNS**2)
    gaps = np.linalg.norm(points[:, None] - points, axis=2) - radii - radii[:, None] + np.diag(4 * radii)
    if gaps.min() >= 0:  # no spheres overlap
        volume = float(4 * math.pi / 3 * (radii**3).sum())
        masses = masses or tuple(radii**3)
    if masses is not None:
        part = np.array(masses, float) / sum(masses)
        centre = part @ points
        second = (points - centre).T @ np.diag(part) @ (points - centre) + np.eye(3) * (part @ radii**2) / 5
    inverse = np.linalg.inv(np.eye(3) * np.trace(second) - second)
    count = min(DIRECTIONS // len(spheres), DIRECTIONS // 10)
    k = np.arange(count) + 0.5
    z, angle = 1 - 2 * k / count, k * math.pi * (3 - math.sqrt(5))
    normals = np.column_stack([np.cos(angle) * np.sqrt(1 - z * z), np.sin(angle) * np.sqrt(1 - z * z), z])
    outer, levers = (normals @ points.T + radii).max(1), [0.0, 0.0]
    for point, radius in zip(points, radii):
        arm = np.cross(point - centre, normals)
        lever = np.einsum("ni,ij,nj->n", arm, inverse, arm)
        away = np.linalg.norm((point + radius * normals)[:, None] - points, axis=2) >= radii - 1e-9 * radius
        levers[0] = max(levers[0], lever[away.all(1)].max(initial=0))
        levers[1] = max(levers[1], lever[normals @ point + radius >= outer - 1e-9 * radius].max(initial=0))
    return volume, (levers[0], levers[1])


@lru_cache(1000)
def superquadric(a: float, b: float, c: float, n: float, m: float) -> Tuple[float, float, Tuple[float, float]]:
    """Returns volume, LIGGGHTS's radius, and levers of the body ((x/a)^m + (y/b)^m)^(n/m) + (z/c)^n <= 1."""
    if not (min(a, b, c) > 0 and min(n, m) >= 2 and max(a, b, c, n, m) < 1e6):
        return math.nan, math.nan, (math.nan, math.nan)

    def beta(p: float, q: float) -> float:
        return math.gamma(p) * math.gamma(q) / math.gamma(p + q)

    area = 2 / m * beta(1 / m, 1 + 1 / m)  # the section at z = 0 has the area 2 a b times this
    height = beta(1 / n, 1 + 2 / n)
    across = beta(3 / m, 1 + 1 / m) / beta(1 / m, 1 + 1 / m) * beta(1 / n, 1 + 4 / n) / height
    xx, yy, zz = a * a * across, b * b * across, c * c * beta(3 / n, 1 + 2 / n) / height
    k = (np.arange(200) + 0.5) * math.pi / 400
    up, round_ = (v.ravel() for v in np.meshgrid(k, k))
    parts = [np.cos(up), np.cos(round_)], [np.cos(up), np.sin(round_)], [np.sin(up), np.ones_like(up)]
    point = np.array([s * p ** (2 / n) * q ** (2 / m) for s, (p, q) in zip((a, b, c), parts)]).T
    normal = np.array([p ** (2 - 2 / n) * q ** (2 - 2 / m) / s for s, (p, q) in zip((a, b, c), parts)]).T
    arm = np.cross(point, normal / np.linalg.norm(normal, axis=1)[:, None])
    lever = float((arm**2 @ (1 / np.array([yy + zz, xx + zz, xx + yy]))).max())
    radius = math.hypot(max(a, b), c) if m == 2 else np.linalg.norm(point, axis=1).max()
    radius = max(a, b, c) if n == m == 2 else radius
    return 4 / n * a * b * c * area * height, 1.0001 * float(radius), (lever, lever)
