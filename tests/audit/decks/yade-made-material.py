# SPDX-License-Identifier: MIT | after YADE scripts with packs, materials by functions and O.reset | GPL-2.0 | speed=1
from yade import pack, ymport
O.bodies.append(ymport.text('first.spheres'))
O.reset()


def grain():
    return FrictMat(young=1e7, density=2600, label='grain')


sp = pack.SpherePack()
sp.makeCloud((0, 0, 0), (1, 1, 1), rMean=.1, rRelFuzz=.5)
O.bodies.append([sphere(c, r, material=grain) for c, r in sp])
O.bodies.append(pack.gtsSurface2Facets(surface, material=lambda: FrictMat(label='floor')))
O.bodies.replaceByClumps([clumpTemplate(relRadii=[1, .5], relPositions=[[0, 0, 0], [.7, 0, 0]])], [.1])
O.engines = [
    InteractionLoop([], [Ip2_FrictMat_FrictMat_MindlinPhys(betan=0.1)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0),
]
