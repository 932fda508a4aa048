# SPDX-License-Identifier: MIT | after YADE examples/baraban/baraban.py | GPL-2.0 | no option
Density = 2400
tc = 0.001
en = 0.3
es = 0.3
sphereMat = O.materials.append(ViscElMat(density=Density, frictionAngle=radians(35), tc=tc, en=en, et=es))
O.dt = .2 * tc
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
