# SPDX-License-Identifier: MIT | after YADE examples/test/facet-sphere-ViscElBasic.py | GPL-2.0 | no option
# the contact of facet-sphere-ViscElBasic.py, given by its spring and dashpot
m = O.materials.append(ViscElMat(density=2400, kn=1.24e8, cn=2.42e4, ks=0, cs=0))
O.bodies.append(sphere((0, 0, 0.1), 0.1, material=m))
O.dt = 1e-5
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
