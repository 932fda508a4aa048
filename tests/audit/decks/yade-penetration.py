# SPDX-License-Identifier: MIT | after YADE examples/DEM2020Benchmark/Case3_PenetrationTest.py | GPL-2.0 | no option
O.materials.append(FrictMat(young=1.0e9, poisson=0.2, density=2500, label='M1'))
O.engines = [
    ForceResetter(),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=MatchMaker(matches=((1, 1, 0.9), (0, 1, 0.7))))], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
