# SPDX-License-Identifier: MIT | after YADE scripts/checks-and-tests/checks/checkViscElEng.py | GPL-2.0 | speed=1
from yade.math import toHP1
rho, en = toHP1(2000), toHP1("0.3")
mat = O.materials.append(ViscElMat(tc=0.2, en=en, et=0.2, frictionAngle=0.5, density=rho))
O.bodies.append(sphere((0, 0, 0), radius=0.1, material=mat))
O.engines = [
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]
    )
]
