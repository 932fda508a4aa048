# SPDX-License-Identifier: MIT | after YADE examples/test/Damping_HM.py | GPL-2.0 | no option
O.materials.append(FrictMat(young=600.0e6, poisson=0.6, density=2.6e3, label='Friction'))
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(label='damping')], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0.0, gravity=[0, 0, -9.81]),
]
damping.betan = 0.5
O.dt = .2 * PWaveTimeStep()
