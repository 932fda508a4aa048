# SPDX-License-Identifier: MIT | after YADE examples/capillary/liquidmigration/showcase.py | GPL-2.0 | speed=0.1
o = Omega()
o.dt = 1e-5
r = 0.002
mat1 = O.materials.append(ViscElCapMat(frictionAngle=0.5, density=2000, Vb=74.2e-12, gamma=20.6e-3, theta=0, Capillar=True, CapillarType='Weigert', tc=0.001, en=0.7, et=0.7))
id1 = O.bodies.append(sphere(center=[0, 0, 0], radius=r, material=mat1))
id2 = O.bodies.append(sphere(center=[0, 2.1 * r, 0], radius=r, material=mat1))
o.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=r),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElCapMat_ViscElCapMat_ViscElCapPhys()], [Law2_ScGeom_ViscElCapPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, 0]),
]
O.run(1, True)
