# SPDX-License-Identifier: MIT | after YADE examples/ResetRandomPosition.py | GPL-2.0 | speed=1
soft, hard = ViscElMat(tc=1e-3, en=0.3, et=0.3, density=2700, label='soft'), ViscElMat(tc=1e-3, en=0.9, et=0.9, density=2700, label='hard')
O.materials.append((soft, hard))
for k in range(2):
    O.bodies.append(sphere((0, 0, .1 * k), .02, material='soft'))
    O.bodies.append(sphere((.1, 0, .1 * k), .02, material='hard'))
O.bodies.append(utils.wall(-1, axis=2, material='hard'))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
O.dt = 1e-5
