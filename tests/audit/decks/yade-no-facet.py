# SPDX-License-Identifier: MIT | after YADE examples/triax-tutorial/script-session1.py | GPL-2.0 | speed=0.1
grain = O.materials.append(ViscElMat(tc=1e-3, en=1, et=1, density=2600))
steel = O.materials.append(ViscElMat(tc=1e-3, en=0.5, et=1, density=7800))
O.bodies.append([sphere((0, 0, 0), 0.003, material=grain), sphere((0, 0, 0.01), 0.003, material=grain)])
O.bodies.append(facet([(0, 0, -9), (1, 0, -9), (0, 1, -9)], material=steel))
O.bodies.append(box((0, 0, -20), (1, 1, 1), material=steel, fixed=True, mask=2))
O.bodies.append([wall(-9, 0, material=grain), wall(-9, 1, material=grain), box((0, 0, -9), (9, 9, 1), fixed=True)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-6
O.run(1)
