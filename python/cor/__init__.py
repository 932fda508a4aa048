# SPDX-License-Identifier: MIT
"""Coefficient of restitution of viscoelastic spheres and of elastic disks.

The modules sphere, contact, law and disk have the functions of the C headers of these names, without their prefix:
cor.sphere.eps_zero_force is cor_sphere_eps_zero_force. Every argument that is a number may be an array. Arrays are
broadcast against each other, as by a ufunc of NumPy, and evaluated in C. Results are float32 if all real arguments are
float32 or float16, and float64 otherwise.

cor.simulators computes the restitution that simulators give. cor.fit fits models to measured bounces.

An error status raises CorError. A status with results issues CorWarning. Both have the text of cor_status_text.
"""

from . import contact, disk, law, simulators, sphere, status, version
from ._contact import Contact
from ._evaluate import CorError, CorWarning
from ._fit.result import fit
from .contact import Body
from .disk import DiskModes

__version__ = version.STRING

__all__ = [
    "Body",
    "Contact",
    "CorError",
    "CorWarning",
    "DiskModes",
    "contact",
    "disk",
    "fit",
    "law",
    "simulators",
    "sphere",
    "status",
    "version",
]
