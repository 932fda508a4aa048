# SPDX-License-Identifier: MIT | after YADE examples/DEM2020Benchmark/Case1_SiloFlow.py | GPL-2.0 | no option
e_M1_M1 = 0.5
O.materials.append(FrictMat(young=1.0e9, poisson=0.2, density=2500, label='M1'))
O.bodies.append(sphere((0, 0, 0), .002, material='M1'))
O.dt = 5e-7
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(val=e_M1_M1, algo='val'))], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
