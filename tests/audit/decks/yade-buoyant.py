# SPDX-License-Identifier: MIT | after YADE examples/FluidCouplingVANS1D/oneWayCoupling/buoyantParticles.py | GPL-2.0 | no option
restitCoef = 0.5
O.materials.append(ViscElMat(en=restitCoef, et=0., young=1e7, poisson=0.5, density=1050, label='Mat1'))
O.dt = 5e-7
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()], [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(gravity=[0, 0, -9.81]),
]
