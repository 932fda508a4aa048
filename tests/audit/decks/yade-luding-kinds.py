# SPDX-License-Identifier: MIT | after YADE examples/LudingPM/LudingPM_2.py | GPL-2.0 | speed=0.1
soft = O.materials.append(LudingMat(frictionAngle=0.5, density=2000, k1=1000, kp=4000, kc=100, ks=0, PhiF=0.05, G0=2))
firm = O.materials.append(LudingMat(frictionAngle=0.5, density=2000, k1=2000, kp=9000, kc=4000, ks=0, PhiF=0.1, G0=0))
O.bodies.append([sphere((0, 0, 0), 0.05, material=soft), sphere((0, 0, 1), 0.03, material=firm)])
O.bodies.append(facet([(0, 0, -9), (1, 0, -9), (0, 1, -9)], material=soft))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_LudingMat_LudingMat_LudingPhys()],
        [Law2_ScGeom_LudingPhys_Basic()],
    ),
    NewtonIntegrator(damping=0.1),
]
O.dt = 1e-5
O.run(10)
