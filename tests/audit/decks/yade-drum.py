# SPDX-License-Identifier: MIT | after YADE examples/DEM2020Benchmark/Case2_rotating_drum.py | GPL-2.0 | speed=0.3
e_gg, e_12, e_wall = 0.97, 0.831, 0.85
Steel = O.materials.append(FrictMat(young=2.1e8, poisson=0.2, density=7850, label='Steel'))
M1 = O.materials.append(FrictMat(young=1.0e8, poisson=0.2, density=2500, label='M1'))
M2 = O.materials.append(FrictMat(young=0.5e8, poisson=0.2, density=2000, label='M2'))
O.bodies.append(sphere((0, 0, 0.01), .002, material=M1))
O.bodies.append(sphere((0, 0, 0.02), .002, material=M1))
O.bodies.append(sphere((0, 0, 0.03), .002, material=M2))
O.bodies.append(sphere((0, 0, 0.04), .002, material=M2))
O.bodies.append(facet([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], material=Steel))
Ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(
    frictAngle=MatchMaker(matches=((M1, M1, 0.5), (Steel, M1, 0.4))),
    en=MatchMaker(matches=((M1, M1, e_gg), (Steel, M1, e_wall), (Steel, M2, e_wall), (M1, M2, e_12), (M2, M2, e_gg))),
)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()], label="collider"),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom(hertzian=True)],
        [Ip2],
        [Law2_ScGeom_MindlinPhys_Mindlin(preventGranularRatcheting=False)],
    ),
    NewtonIntegrator(damping=0, gravity=[0, 0, -9.81], label="newton"),
]
O.dt = 5e-7
O.run(1000, True)
