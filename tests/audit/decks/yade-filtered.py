# SPDX-License-Identifier: MIT | after esahin95/YadeProjects funnelTest.py, spheres from a filtered packing | no licence | speed=1
from yade import pack
cloud = pack.SpherePack()
cloud.makeCloud((0, 0, 0), (1, 1, 1), rMean=0.1)
cloud = pack.filterSpherePack(pack.inSphere((0, 0, 0), 1), cloud, returnSpherePack=True)
cloud.toSimulation()
O.bodies.append(wall(-1, axis=2))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.7)],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-5
O.run(1, True)
