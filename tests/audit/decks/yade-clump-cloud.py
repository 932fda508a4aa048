# SPDX-License-Identifier: MIT | after YADE examples/test/clumpPack.py, and clumps that a loop collects | GPL-2.0 | speed=1
from yade import pack
shape = pack.SpherePack([((0, 0, 0), .5), ((.5, 0, 0), .3)])
sp = pack.SpherePack()
print 'clumps:', sp.makeClumpCloud((0, 0, 0), (15, 15, 15), [shape])
print >>sys.stderr, 'a line that is left out'
sp.toSimulation()
for shape in shapes:
    members = []
    for centre in shape:
        members.append(sphere(centre, .1, material=FrictMat(label='part')))
    O.bodies.appendClumped(members)
O.engines = [
    InteractionLoop([], [Ip2_FrictMat_FrictMat_FrictPhys()], [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(damping=.4),
]
