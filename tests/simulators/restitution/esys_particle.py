# SPDX-License-Identifier: MIT
# Head-on collision of two spheres in ESyS-Particle with the text of corgen contact --for esys-particle.
#     mpirun -np 2 esysparticle esys_particle.py PASTE DURATION N
# prints, with DURATION/(N + 1/2) s as the time step, eps N VALUE CHANGE. CHANGE of the velocity after the contact must
# be 0. SI units.
import os
import sys

import esys.lsm
from esys.lsm import *
from esys.lsm.util import BoundingBox, Vec3

# without this hook the other MPI process waits forever after an error
sys.excepthook = lambda *error: (sys.__excepthook__(*error), os._exit(1))
paste, duration, count = sys.argv[1], float(sys.argv[2]), int(sys.argv[3])
call = next(line for line in open(paste) if "Prms(" in line)
kind = "RotSphere" if "Mindlin" in call else "NRotSphere"
sim = LsmMpi(1, [1, 1, 1])
sim.initNeighbourSearch(particleType=kind, gridSpacing=0.1, verletDist=5e-4)
sim.setSpatialDomain(BoundingBox(Vec3(-1, -1, -1), Vec3(1, 1, 1)))
for number, (place, radius, mass) in enumerate([(5e-3, 5e-3, 2e-3), (-2e-2, 2e-2, 8e-3)]):
    body = getattr(esys.lsm, kind)(id=number, posn=Vec3(place, 0, 0), radius=radius, mass=mass)
    body.setLinearVelocity(Vec3(number - 1, 0, 0))
    sim.createParticle(body)
sim.createInteractionGroup(eval(call))
sim.setTimeStepSize(duration / (count + 0.5))
values = []
for steps in (int(1.3 * count), int(0.1 * count)):
    for _ in range(steps):
        sim.runTimeStep()
    speeds = {body.getId(): body.getLinearVelocity()[0] for body in sim.getParticleList()}
    values.append(speeds[0] - speeds[1])
print("eps %d %.17g %.3g" % (count, values[1], values[1] - values[0]))
sim.exit()
