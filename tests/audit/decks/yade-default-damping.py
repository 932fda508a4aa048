# SPDX-License-Identifier: MIT | after YADE examples/test/mindlin.py | GPL-2.0 | speed=1
m = O.materials.append(FrictMat(young=600.0e6, poisson=0.3, density=2600, frictionAngle=0.3))
O.bodies.append(sphere((0, 0, 0), 0.1, material=m, fixed=True))
O.bodies.append(sphere((0, 0, 0.21), 0.1, material=m))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.7)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(gravity=(0, 0, -9.81)),
]
O.dt = 1e-6
