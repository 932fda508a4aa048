# SPDX-License-Identifier: MIT | after YADE examples/DEM2020Benchmark/Case3_PenetrationTest.py, with labels | GPL-2.0 | speed=0.2
for name, young, density in (('M1', 1.0e8, 2500), ('M2', 5.0e7, 2000), ('Steel', 2.1e9, 7200)):
    O.materials.append(FrictMat(young=young, poisson=0.2, density=density, label=name))
e = {'M1': 0.5, 'M2': 0.4}
O.bodies.append(sphere((0, 0, 0), .002, material='M1'))
O.bodies.append(sphere((0, 0, .01), .002, material='M1'))
O.bodies.append(sphere((0, 0, .1), .01, material='Steel'))
en = MatchMaker(algo="val", val=0.55, matches=((0, 0, e['M1']), (1, 1, e['M2']), (0, 2, 0.6)))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=en)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81]),
]
O.dt = 1e-6
O.run(1, True)
