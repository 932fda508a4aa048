# SPDX-License-Identifier: MIT | after YADE examples/LudingPM.py | GPL-2.0 | speed=0.01
from yade import utils, plot
o = Omega()
o.dt = 0.0002
r1 = r2 = 2.0e-1
k1 = 105.0
kp = 5.0 * k1
PhiF = 0.031 * (kp - k1) * (r1 + r2) / (kp * 2 * r1 * r2)
mat1 = O.materials.append(LudingMat(frictionAngle=0.5, density=2000, k1=k1, kp=kp, kc=0.0, ks=0.0, PhiF=PhiF, G0=0.0))
O.bodies.append(sphere(center=[0, 0, 0], radius=r1, material=mat1, fixed=True))
O.bodies.append(sphere(center=[0, 0, r1 + r2], radius=r2, material=mat1, fixed=False))
o.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_LudingMat_LudingMat_LudingPhys()], [Law2_ScGeom_LudingPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, 0]),
]
O.run(320000)
O.wait()
plot.saveGnuplot('sim-data_LudigPM')
