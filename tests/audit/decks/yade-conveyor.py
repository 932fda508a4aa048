# SPDX-License-Identifier: MIT | after YADE examples/conveyor/conveyor.py | GPL-2.0 | speed=0.2
tc = 0.001
en = 0.3
mat = O.materials.append(ViscElMat(density=1000, frictionAngle=0.4, tc=tc, en=en, et=0.3))
O.bodies.append([sphere(c, 0.03, mask=3) for c in ((0, 0, 0.1), (0.1, 0, 0.1), (0.2, 0, 0.1))])
belt = O.bodies.append([facet([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], mask=5)])
for i in belt:
    O.bodies[i].state.vel = Vector3(0, 0.2, 0)
O.dt = .2 * tc
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81], mask=2),
    DomainLimiter(lo=(-0.6, -1.0, -1.0), hi=(0.6, 2.0, 1.0), iterPeriod=200),
]
