# SPDX-License-Identifier: MIT | after YADE examples/ViscElMatchMaker.py | GPL-2.0 | speed=0.5
o = Omega()
tc = 0.001
en = 0.5
o.dt = 0.002 * tc
r = 0.002381
m1, m2, m3 = [O.materials.append(ViscElMat(frictionAngle=0.5, tc=tc, en=en, et=en, density=2000)) for k in range(3)]
for k, (below, above) in enumerate(((m1, m2), (m1, m3), (m2, m3))):
    O.bodies.append(sphere((3 * k * r, 0, 0), r, material=below, fixed=True))
    O.bodies.append(sphere((3 * k * r, 0, 2.01 * r), r, material=above))
pairs = ((m1, m2, 0.9), (m1, m3, 0.5), (m2, m3, 0.1))
o.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_ViscElMat_ViscElMat_ViscElPhys(en=MatchMaker(matches=pairs), et=MatchMaker(matches=pairs))],
        [Law2_ScGeom_ViscElPhys_Basic()],
    ),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
O.step()
