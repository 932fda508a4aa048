# SPDX-License-Identifier: MIT | after YADE examples/PIDController.py | GPL-2.0 | no option
rho = 2000
tc = 0.001
en = 0.3
o = Omega()
o.dt = 0.02 * tc
mat1 = O.materials.append(ViscElMat(frictionAngle=0.0, density=rho, tc=tc, en=en, et=0.3))
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
