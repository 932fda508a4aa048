# SPDX-License-Identifier: MIT
"""Draws eps against the impact speed for spheres of one material, for both ends of contact.

    python3 eps_over_speed.py [FILE]        eps_over_speed.svg unless a file is named; its name determines the format
"""

import sys

import numpy as np

import cor

# Glass spheres of 1 cm diameter. A is chosen so that eps is 0.97 at 0.1 m/s, where contacts end at zero force.
GLASS = {"young": 70e9, "poisson": 0.22, "radius": 5e-3, "density": 2500.0}
MEASURED_EPS, MEASURED_SPEED_M_S = 0.97, 0.1


def main() -> int:
    try:
        import matplotlib
    except ImportError:
        print("eps_over_speed.py: matplotlib is not installed", file=sys.stderr)
        return 1
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    contact = cor.Contact(**GLASS, restitution=MEASURED_EPS, at=MEASURED_SPEED_M_S, end="zero_force")
    dissipation_time_s = contact.quantities["dissipation_time"]

    speed_m_s = np.geomspace(1e-4, 10.0, 400)
    figure, axes = plt.subplots()
    axes.semilogx(speed_m_s, contact.eps(speed_m_s), label="zero force")
    axes.semilogx(speed_m_s, contact.eps(speed_m_s, "zero_overlap"), "--", label="zero overlap")
    axes.plot(MEASURED_SPEED_M_S, MEASURED_EPS, "o", label="measured")
    axes.set_xlabel("impact speed, m/s")
    axes.set_ylabel("eps")
    axes.legend(title="contact ends at")
    path = sys.argv[1] if len(sys.argv) > 1 else "eps_over_speed.svg"
    figure.savefig(path)
    print(f"A = {dissipation_time_s:.4e} s, eps(1 m/s) = {contact.eps(1.0):.6f}; drawn: {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
