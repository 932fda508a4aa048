# SPDX-License-Identifier: MIT | after YADE examples/PeriodicBoundaries/periodicSandPile.py | GPL-2.0 | speed=0.5
from yade import pack
O.materials.append(FrictMat(density=1, young=1e5, poisson=0.3, frictionAngle=radians(30), label='boxMat'))
O.bodies.append(box(center=(0.2, 0, 0.1), extents=(0.2, 0.005, 0.1), fixed=True, material='boxMat'))
radius = 0.01
O.materials.append(FrictMat(density=1000, young=1e4, poisson=0.3, frictionAngle=radians(30), label='sphereMat'))
sp = pack.SpherePack()
sp.makeCloud((0, 0.1, 0), (0.4, 0.3, 0.2), rMean=radius, num=20)
O.bodies.append([sphere(s[0], radius, material='sphereMat') for s in sp])
O.dt = 1e-4
newton = NewtonIntegrator(damping=0.6, gravity=(0, -10, 0))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Box_Aabb(), Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_FrictPhys()],
        [Law2_ScGeom_FrictPhys_CundallStrack()],
    ),
    newton,
]
print('Press PLAY button')
