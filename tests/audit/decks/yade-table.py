# SPDX-License-Identifier: MIT | after YADE examples/test/batch/sim.py | GPL-2.0 | speed=1
from yade import utils
utils.readParamsFromTable(unknownOk=True, noTableOk=True, en=0.6, young=1e8)
from yade.params.table import *
from yade.params import table
m = O.materials.append(FrictMat(young=young, poisson=.3, density=2500, frictionAngle=0.4))
O.bodies.append(sphere((0, 0, 0), .01, material=m))
O.bodies.append(sphere((0, 0, .03), .01, material=m))
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=table.en, es=en)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
O.dt = 1e-6
O.run(10, True)
