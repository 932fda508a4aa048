# SPDX-License-Identifier: MIT | after YADE examples/HydroForceEngine/validations/DEMCoupling | GPL-2.0 | speed=0.2
grain = O.materials.append(FrictMat(young=1e8, poisson=0.3, density=2600, frictionAngle=0.4))
O.bodies.append([sphere((0, 0, 0), 0.003, material=grain), sphere((0, 0, 0.01), 0.003, material=grain), wall(-1, 2)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, es=0.5)],
        [Law2_ScGeom_MindlinPhys_HertzWithLinearShear()],
    ),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-6
O.run(1)
