# SPDX-License-Identifier: MIT | after YADE doc/sphinx/tutorial/01-bouncing-sphere.py | GPL-2.0 | speed=1
O.bodies.append([utils.sphere(center=(0, 0, 0), radius=.5, fixed=True), utils.sphere((0, 0, 2), .5)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(gravity=(0, 0, -9.81), damping=0.1),
]
O.dt = .05 * utils.PWaveTimeStep()
O.saveTmp()
