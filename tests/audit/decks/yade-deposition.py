# SPDX-License-Identifier: MIT | after YADE doc/sphinx/tutorial/02-gravity-deposition.py | GPL-2.0 | speed=1
from yade import pack, plot
O.bodies.append(geom.facetBox((.5, .5, .5), (.5, .5, .5), wallMask=31))
sp = pack.SpherePack()
sp.makeCloud((0, 0, 0), (1, 1, 1), rMean=.05, rRelFuzz=.5)
sp.toSimulation()
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Facet_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_FrictPhys()],
        [Law2_ScGeom_FrictPhys_CundallStrack()],
    ),
    NewtonIntegrator(gravity=(0, 0, -9.81), damping=0.4),
    PyRunner(command='checkUnbalanced()', realPeriod=2),
]
O.dt = .5 * PWaveTimeStep()
O.trackEnergy = True


def checkUnbalanced():
    if unbalancedForce() < .05:
        O.pause()
        plot.saveDataTxt('bbb.txt.bz2')


plot.plots = {'i': ('unbalanced', None, O.energy)}
plot.plot()
O.saveTmp()
