# SPDX-License-Identifier: MIT | after YADE examples/DeformEngine/OedometricDeform.py | GPL-2.0 | no option
tc = 0.002
en = 0.7
mat1 = O.materials.append(ViscElMat(frictionAngle=0.5, tc=tc, en=en, et=0.7))
O.dt = .01 * tc
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0.1, gravity=[0, 0, -9.81]),
]
