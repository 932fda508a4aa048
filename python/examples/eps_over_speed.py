# SPDX-License-Identifier: MIT
"""Draws eps against the impact speed for spheres of one material, for both ends of contact.

    python3 eps_over_speed.py [FILE]        eps_over_speed.svg unless a file is named; its name says the format
"""

import sys

import numpy as np

import cor

# Glass spheres of 1 cm diameter. A is chosen so that eps is 0.97 at 0.1 m/s, where contacts end at zero force.
RADIUS_M = 5e-3
MASS_KG = cor.contact.sphere_mass_kg(RADIUS_M, 2500.0)
MEASURED_EPS, MEASURED_SPEED_M_S = 0.97, 0.1


def glass(dissipation_time_s: float) -> cor.Body:
    return cor.Body(70e9, 0.22, dissipation_time_s, RADIUS_M, MASS_KG)


def main() -> int:
    try:
        import matplotlib
    except ImportError:
        print("eps_over_speed.py: matplotlib is not installed", file=sys.stderr)
        return 1
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    elastic = cor.Contact(glass(0.0), glass(0.0))
    dissipation_time_s = elastic.dissipation_time_s_zero_force(MEASURED_SPEED_M_S, MEASURED_EPS)
    contact = cor.Contact(glass(dissipation_time_s), glass(dissipation_time_s))

    speed_m_s = np.geomspace(1e-4, 10.0, 400)
    figure, axes = plt.subplots()
    axes.semilogx(speed_m_s, contact.eps_zero_force(speed_m_s), label="zero force")
    axes.semilogx(speed_m_s, contact.eps_zero_overlap(speed_m_s), "--", label="zero overlap")
    axes.plot(MEASURED_SPEED_M_S, MEASURED_EPS, "o", label="measured")
    axes.set_xlabel("impact speed, m/s")
    axes.set_ylabel("eps")
    axes.legend(title="contact ends at")
    path = sys.argv[1] if len(sys.argv) > 1 else "eps_over_speed.svg"
    figure.savefig(path)
    print(f"A = {dissipation_time_s:.4e} s, eps(1 m/s) = {contact.eps_zero_force(1.0):.6f}; drawn: {path}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
