# SPDX-License-Identifier: MIT | after YADE examples/billiard.py | GPL-2.0 | speed=10
radius = 1.0
density = 1.0 / (4.0 / 3.0 * math.pi * pow(radius, 3.0))
kn = 1e6
cn = 60.0
param = {'kn': kn * 2.0, 'ks': kn * 2.0, 'cn': cn * 2.0, 'cs': cn * 2.0}
ball = O.materials.append(ViscElMat(density=density, frictionAngle=0.0, **param))
ids = []
for row in range(0, 3):
    for i in range(row + 1):
        ids.append(O.bodies.append(sphere([2 * i - row, row * sqrt(3.0), 0.0], radius, material=ball)))
O.dt = 2e-5
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0),
]
from yade import qt
qt.View()
