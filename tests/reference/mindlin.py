#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Oblique impacts of elastic spheres by the theory of Mindlin and Deresiewicz, next to the models of simulators.

    tests/reference/mindlin.py [--write]    CORGEN names corgen; --write renews docs/oblique.csv and docs/oblique.svg

Prints the difference of u'/u of each model from the theory. Maw, Barber and Fawcett, Wear 38, 101 (1976), integrate it by
annuli. Here springs on a line replace the half-space (Popov and Hess, Method of Dimensionality Reduction, 2015). A
spring at z has the normal force (x - z^2) dz, and a tangential one of at most mu times that. Needs numpy.
"""
import csv
import io
import math
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
MODELS = ("displacement", "force", "rescaled", "rescaled-force")
FRICTION = 0.1
# tan(angle) over 7 mu/(2 kappa), with which u'/u does not depend on mu
ANGLES = np.concatenate([np.arange(0.05, 2, 0.05), np.arange(2, 10.5, 0.25)])


def mindlin(kappa: float, springs: int = 1200, steps: int = 6000) -> np.ndarray:
    """Returns u'/u at ANGLES. x'' = -x^(3/2) in the units of the collision, in which the springs give (3/2) dz."""
    z = (np.arange(springs) + 0.5) / springs * math.sqrt(1.1)
    dz = z[1] - z[0]
    w = ANGLES * 3.5 * FRICTION / kappa
    start, s = w.copy(), np.zeros((len(ANGLES), springs))
    x, v, step = 0.0, 1.0, 3.3 / steps
    while x >= 0:
        v -= step / 2 * max(x, 0) ** 1.5
        x += step * v
        cap = 3.5 * FRICTION * 1.5 * dz * np.maximum(x - z * z, 0)
        s = np.clip(s + kappa * dz * step * w[:, None], -cap, cap)  # no force without contact
        w = w - step * s.sum(1)
        v -= step / 2 * max(x, 0) ** 1.5
    return w / start


def simulated(model: str, poisson: float, kappa: float) -> np.ndarray:
    speeds = ",".join("%.15g" % (angle * 3.5 * FRICTION / kappa) for angle in ANGLES)
    words = "contact --young 1e9 --radius 1e-3 --density 1000 --dissipation-time 0 --speed 1 --format csv".split()
    words += ["--poisson", str(poisson), "--friction", str(FRICTION), "--tangential", model]
    out = subprocess.run([os.environ.get("CORGEN", "build/corgen"), *words, "--tangential-speed", speeds],
                         stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout
    return np.array([-float(row["tangential_restitution"]) for row in csv.DictReader(io.StringIO(out))])


def main() -> int:
    rows = []
    for poisson in 0.0, 0.3, 0.5:
        kappa = 10.5 * (1 - poisson) / (2 - poisson)
        exact = mindlin(kappa)
        half = mindlin(kappa, 600, 3000)
        columns = [simulated(model, poisson, kappa) for model in MODELS]
        off = ", ".join("%s %.3f" % (m, abs(c - exact).max()) for m, c in zip(MODELS, columns))
        print("nu = %g: %s; error of the theory's numbers about %.0e" % (poisson, off, abs(exact - half).max()))
        rows += [[poisson, angle, *values] for angle, *values in zip(ANGLES, exact, *columns)]
        gross = ANGLES > 9.5  # everything slips: 1 - 2 kappa/w_0
        if abs(exact - (1 - 2 * kappa / ANGLES))[gross].max() > 2e-3:
            print("the limit of gross slip is wrong")
            return 1
    if sys.argv[1:] == ["--write"]:
        text = "poisson,incidence,mindlin," + ",".join(MODELS).replace("-", "_") + "\n"
        text += "".join("%g,%g," % tuple(row[:2]) + ",".join("%.5f" % x for x in row[2:]) + "\n" for row in rows)
        (ROOT / "docs/oblique.csv").write_text(text)
        subprocess.run(["gnuplot", "bench/plots/oblique.gp"], cwd=ROOT, check=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
