# SPDX-License-Identifier: MIT | after YADE examples/clumps/clump-inbox-viscoelastic.py | GPL-2.0 | speed=1
from yade import utils, pack, export, geom
tc = 0.001; en = .3; es = .3
params = dict(tc=tc, en=en, et=es)
walls = O.materials.append(ViscElMat(frictionAngle=radians(35), density=2700, **params))
grains = O.materials.append(ViscElMat(frictionAngle=radians(35), density=2700, **params))
O.dt = .01 * tc
Rs = 0.1
O.bodies.append(geom.facetBox((0, 0, 0), (1, 1, 1), wallMask=31, material=walls))
for j in range(2):
    O.bodies.appendClumped([utils.sphere(Vector3(0, Rs * 2 * i, (j + 1) * Rs * 2), Rs, material=grains) for i in range(4)])
O.bodies.append([utils.sphere(Vector3(0.5, Rs * 2 * i, Rs * 2), Rs, material=grains) for i in range(4)])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
O.saveTmp()
